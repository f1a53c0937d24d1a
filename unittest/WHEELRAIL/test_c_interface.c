// SPDX-License-Identifier: GPL-2.0-or-later
/* wheelrail.h from C: results, faults by their codes and words, two objects on two threads. */
#include "wheelrail.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int faults = 0;

static void check(int condition, const char *what, int line)
{
  if (!condition) {
    fprintf(stderr, "line %d: %s\n", line, what);
    ++faults;
  }
}
#define CHECK(condition) check(condition, #condition, __LINE__)
#define SAYS(contact, words) check(strstr(wheelrail_error(contact), words) != NULL, words, __LINE__)

static const char *text =
    "contact: {load: 100 kN, radii: {wheel_rolling: 0.5 m, rail_profile: 0.3 m}, youngs_modulus: "
    "210 GPa, poissons_ratio: 0.3}\n"
    "friction: {law: constant, mu: 0.3}\nthermal: off\ncreep: 0\nspeed: 20 m/s\n"
    "cells: [48, 44]\n";

static void test_forces(void)
{
  wheelrail_contact *contact;
  wheelrail_forces forces = {0.0, 0.0, 0.0};
  double value = 0.0;
  CHECK(wheelrail_create_from_text(text, &contact) == WHEELRAIL_OK);
  CHECK(wheelrail_get_forces(contact, &forces) == WHEELRAIL_USAGE);
  SAYS(contact, "there is no result");
  CHECK(wheelrail_set_creepages(contact, 0.1, 0.0, 0.0) == WHEELRAIL_OK);
  CHECK(wheelrail_step(contact) == WHEELRAIL_OK);
  CHECK(wheelrail_get_forces(contact, &forces) == WHEELRAIL_OK);
  CHECK(*wheelrail_error(contact) == '\0');
  CHECK(fabs(forces.force_x + 0.3 * 100e3) < 1.0); /* full sliding: mu times the load */
  CHECK(wheelrail_get_value(contact, "mu_mean", &value) == WHEELRAIL_OK);
  CHECK(fabs(value - 0.3) < 1e-9);
  CHECK(wheelrail_get_value(contact, "mu_meen", &value) == WHEELRAIL_USAGE);
  SAYS(contact, "mu_mean");
  const char *named[] = {
      "approach", "peak_pressure",    "real_area",       "power",
      "mu_mean",  "temperature_rise", "temperature_max", "stick_fraction"}; /* in the header */
  for (size_t k = 0; k < sizeof named / sizeof *named; ++k)
    CHECK(wheelrail_get_value(contact, named[k], &value) == WHEELRAIL_OK);
  CHECK(wheelrail_get_value(contact, "shift_x", &value) == WHEELRAIL_USAGE); /* of mode static */
  wheelrail_free(contact);
}

static void test_fields(void)
{
  wheelrail_contact *contact;
  int nx = 0, ny = 0;
  double dx = 0.0, dy = 0.0, x = 0.0, y = 0.0, load = 0.0;
  CHECK(wheelrail_create_from_text(text, &contact) == WHEELRAIL_OK);
  CHECK(wheelrail_get_grid(contact, &nx, &ny, &dx, &dy, &x, &y) == WHEELRAIL_OK);
  CHECK(nx == 48 && ny == 44 && x < 0.0 && y < 0.0);
  CHECK(fabs(x + 0.5 * (nx - 1) * dx) < 1e-9 && fabs(y + 0.5 * (ny - 1) * dy) < 1e-9);
  CHECK(wheelrail_get_grid(contact, NULL, NULL, NULL, NULL, NULL, NULL) == WHEELRAIL_OK);
  const size_t cells = (size_t)nx * (size_t)ny;
  double *values = malloc(cells * sizeof *values);
  CHECK(wheelrail_set_load(contact, 80e3) == WHEELRAIL_OK);
  CHECK(wheelrail_step(contact) == WHEELRAIL_OK);
  CHECK(wheelrail_get_field(contact, "pressure", values, cells) == WHEELRAIL_OK);
  for (size_t k = 0; k < cells; ++k)
    load += values[k] * dx * dy;
  CHECK(fabs(load - 80e3) < 1e-3);
  CHECK(wheelrail_get_field(contact, "pressure", values, cells - 1) == WHEELRAIL_USAGE);
  SAYS(contact, "2112 are needed");
  CHECK(wheelrail_get_field(contact, "heat", values, cells) == WHEELRAIL_USAGE);
  CHECK(wheelrail_get_field(contact, NULL, values, cells) == WHEELRAIL_USAGE);
  free(values);
  wheelrail_free(contact);
}

static void test_faults(void)
{
  wheelrail_contact *contact;
  wheelrail_forces forces;
  CHECK(wheelrail_create("no such case.yaml", &contact) == WHEELRAIL_BAD_INPUT);
  SAYS(contact, "no such case.yaml");
  CHECK(wheelrail_step(contact) == WHEELRAIL_USAGE);
  SAYS(contact, "was not created");
  wheelrail_free(contact);
  CHECK(wheelrail_create_from_text("contact: {load: -1 kN}\n", &contact) == WHEELRAIL_BAD_INPUT);
  SAYS(contact, "case:1: contact.load: '-1 kN'");
  wheelrail_free(contact);
  CHECK(wheelrail_create(NULL, &contact) == WHEELRAIL_USAGE);
  wheelrail_free(contact);
  CHECK(wheelrail_create_from_text(text, &contact) == WHEELRAIL_OK);
  CHECK(wheelrail_set_load(contact, -3.0) == WHEELRAIL_USAGE);
  SAYS(contact, "contact.load: '-3' is not in the allowed range");
  CHECK(wheelrail_set_load(contact, 8.0) == WHEELRAIL_BAD_INPUT);
  SAYS(contact, "contact.load: 8 N: ");
  CHECK(wheelrail_set_speed(contact, NAN) == WHEELRAIL_USAGE);
  CHECK(wheelrail_get_forces(contact, NULL) == WHEELRAIL_USAGE);
  CHECK(wheelrail_set_load(contact, 300e3) == WHEELRAIL_OK);
  CHECK(wheelrail_step(contact) == WHEELRAIL_BAD_INPUT);
  SAYS(contact, "contact.domain");
  CHECK(wheelrail_set_load(contact, 100e3) == WHEELRAIL_OK);
  CHECK(wheelrail_step(contact) == WHEELRAIL_OK);
  wheelrail_free(contact);
  CHECK(wheelrail_create(NULL, NULL) == WHEELRAIL_USAGE);
  CHECK(wheelrail_step(NULL) == WHEELRAIL_USAGE);
  CHECK(wheelrail_get_forces(NULL, &forces) == WHEELRAIL_USAGE);
  CHECK(strlen(wheelrail_error(NULL)) > 0);
  wheelrail_free(NULL);
}

enum { STEPS = 40 };
struct drive {
  double sign;
  double force[STEPS];
};

static void *roll(void *argument)
{
  struct drive *drive = argument;
  wheelrail_contact *contact;
  wheelrail_forces forces = {0.0, 0.0, 0.0};
  wheelrail_create_from_text(text, &contact);
  for (int k = 0; k < STEPS; ++k) {
    wheelrail_set_creepages(contact, drive->sign * 1e-4 * (k + 1), 1e-5 * k, 0.0);
    wheelrail_step(contact);
    wheelrail_get_forces(contact, &forces);
    drive->force[k] = forces.force_x;
  }
  wheelrail_free(contact);
  return NULL;
}

/* One after the other and side by side give the same to the last bit. */
static void test_threads(void)
{
  struct drive alone[2] = {{1.0, {0.0}}, {-1.0, {0.0}}},
               together[2] = {{1.0, {0.0}}, {-1.0, {0.0}}};
  pthread_t threads[2];
  for (int k = 0; k < 2; ++k)
    roll(&alone[k]);
  for (int k = 0; k < 2; ++k)
    pthread_create(&threads[k], NULL, roll, &together[k]);
  for (int k = 0; k < 2; ++k)
    pthread_join(threads[k], NULL);
  for (int k = 0; k < 2; ++k)
    CHECK(memcmp(alone[k].force, together[k].force, sizeof alone[k].force) == 0);
  CHECK(alone[0].force[STEPS - 1] < -20e3 && alone[1].force[STEPS - 1] > 20e3);
}

int main(void)
{
  CHECK(strlen(wheelrail_version()) > 0);
  test_forces();
  test_fields();
  test_faults();
  test_threads();
  return faults ? 1 : 0;
}
