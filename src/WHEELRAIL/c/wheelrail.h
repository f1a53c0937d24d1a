// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_H
#define WHEELRAIL_H

// A header of C, with C's names:
// NOLINTBEGIN(modernize-use-using,modernize-deprecated-headers,modernize-redundant-void-arg,readability-identifier-naming)
#include <stddef.h>

/*
 * The point contact of wr_creep from C, from Fortran, or from a multibody code: a wheel and a rail
 * that roll steadily, asked for one operating point after the other.
 *
 *   wheelrail_contact *contact;
 *   if (wheelrail_create("patch.yaml", &contact) != WHEELRAIL_OK) ...  wheelrail_error(contact)
 *   wheelrail_set_creepages(contact, 1e-3, 0.0, 0.0);
 *   wheelrail_step(contact);
 *   wheelrail_get_forces(contact, &forces);
 *   wheelrail_free(contact);
 *
 * Units are SI. Axes and signs are those of a case file: x is the rolling direction, y lies across,
 * and forces act on the wheel, against its slip, so that a positive creep gives a negative force_x.
 *
 * Every call that can fail returns WHEELRAIL_OK or another code of `wheelrail_code`; what is wrong
 * is then told by `wheelrail_error` in one line. Nothing is printed, and no call ends the program.
 *
 * An object belongs to one thread at a time; different objects may be used by different threads at
 * once. A program that uses FFTW itself must not make plans of its own meanwhile.
 */
#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define WHEELRAIL_API __attribute__((visibility("default")))
#else
#define WHEELRAIL_API
#endif

/** A contact with its surfaces, its law of friction and its last solution. */
typedef struct wheelrail_contact wheelrail_contact;

/** What a call returns: the exit codes of the programs. */
typedef enum wheelrail_code {
  WHEELRAIL_OK = 0,
  WHEELRAIL_INTERNAL = 1,      /**< a bug of ours, or no memory */
  WHEELRAIL_USAGE = 2,         /**< an argument of the call, or the order of calls */
  WHEELRAIL_BAD_INPUT = 3,     /**< the case, or a file that it names */
  WHEELRAIL_NOT_CONVERGED = 4, /**< the next step begins cold and may succeed */
  WHEELRAIL_IO = 5             /**< a file cannot be read or written */
} wheelrail_code;

/** Force and moment on the wheel: N and N m, the moment about the normal through the origin. */
typedef struct wheelrail_forces {
  double force_x, force_y, moment_z;
} wheelrail_forces;

/** "1.0.0 (commit)"; lives as long as the program. */
WHEELRAIL_API const char *wheelrail_version(void);

/**
 * Reads a case and solves its normal contact. The first speed, creep, lateral creep and spin of the
 * case are set, and its largest load, which decides on the box of cells; the box then stays.
 *
 * `case_file`: path of a case file (YAML): a point contact in mode frozen that has creepages, not
 * forces, and one surface.
 * `contact`: never null; afterwards it is to be given to `wheelrail_free`, whatever was returned.
 * Where creating failed it answers `wheelrail_error` and fails in all else. It is null where there
 * is no memory.
 */
WHEELRAIL_API int wheelrail_create(const char *case_file, wheelrail_contact **contact);
/** `wheelrail_create` with the text of a case file. Files that it names are looked for from the
 * working folder. */
WHEELRAIL_API int wheelrail_create_from_text(const char *case_text, wheelrail_contact **contact);

/**
 * Creepages of the wheel against the rail over the rolling speed: longitudinal and lateral ones are
 * pure numbers, spin in 1/m. They count from the next step on. WHEELRAIL_USAGE for values that the
 * keywords creep, lateral and spin of a case are not allowed; then all three stay.
 */
WHEELRAIL_API int wheelrail_set_creepages(wheelrail_contact *contact, double creep, double lateral,
                                          double spin);
/** Normal force, N, likewise. WHEELRAIL_BAD_INPUT for a load whose contact is on fewer than 4 cells
 * across; then it stays. A load whose contact reaches the border of the box is refused by the next
 * step. */
WHEELRAIL_API int wheelrail_set_load(wheelrail_contact *contact, double load);
/** Rolling speed, m/s, likewise. */
WHEELRAIL_API int wheelrail_set_speed(wheelrail_contact *contact, double speed);

/** Solves for what is set. It begins at the step before, which makes it fast; the result depends on
 * that within the tolerance of the solver only. */
WHEELRAIL_API int wheelrail_step(wheelrail_contact *contact);

/** Forces of the last step; WHEELRAIL_USAGE where there is none, or it failed. */
WHEELRAIL_API int wheelrail_get_forces(wheelrail_contact *contact, wheelrail_forces *forces);
/**
 * One number of the last step, in SI units, by the name of its column in creep.csv: "approach",
 * "peak_pressure", "real_area", "power", "mu_mean", "temperature_rise",
 * "temperature_max", "stick_fraction" and so on. WHEELRAIL_USAGE for another name.
 */
WHEELRAIL_API int wheelrail_get_value(wheelrail_contact *contact, const char *name, double *value);

/** The cells of the box: their numbers along x and y, the size of one (m), and the centre of the
 * first one (m). Each pointer may be null. */
WHEELRAIL_API int wheelrail_get_grid(wheelrail_contact *contact, int *nx, int *ny, double *dx,
                                     double *dy, double *x, double *y);
/**
 * A field of the last step: "state" (0 apart, 1 stick, 2 slip), "gap" (m), "pressure",
 * "traction_x", "traction_y" (Pa), "slip_x", "slip_y" (over the rolling speed), "mu",
 * "temperature" (rise, K).
 *
 * `values`: room for nx * ny numbers, x fastest; `count`: how many fit. WHEELRAIL_USAGE where they
 * are too few, and for another name.
 */
WHEELRAIL_API int wheelrail_get_field(wheelrail_contact *contact, const char *name, double *values,
                                      size_t count);

/** What was wrong with the last call for this object, in one line; empty after WHEELRAIL_OK. Valid
 * until the next call for it. */
WHEELRAIL_API const char *wheelrail_error(const wheelrail_contact *contact);

/** Ends the object; null is allowed. */
WHEELRAIL_API void wheelrail_free(wheelrail_contact *contact);

#ifdef __cplusplus
}
#endif
// NOLINTEND(modernize-use-using,modernize-deprecated-headers,modernize-redundant-void-arg,readability-identifier-naming)
#endif
