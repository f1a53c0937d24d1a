// SPDX-License-Identifier: GPL-2.0-or-later
/* Forces on a wheel from C: a lateral movement through a contact whose load changes, as a multibody
 * code asks for it in each of its steps.
 *   cc forces.c $(pkg-config --cflags --libs wheelrail) -lm -o forces && ./forces case.yaml
 */
#include "wheelrail.h"

#include <math.h>
#include <stdio.h>

static int fail(wheelrail_contact *contact, int code)
{
  fprintf(stderr, "forces: %s\n", wheelrail_error(contact));
  wheelrail_free(contact);
  return code;
}

int main(int argc, char **argv)
{
  if (argc != 2) {
    fprintf(stderr, "usage: forces CASE.yaml\n");
    return WHEELRAIL_USAGE;
  }
  wheelrail_contact *contact;
  int code = wheelrail_create(argv[1], &contact);
  if (code != WHEELRAIL_OK)
    return fail(contact, code);

  const double pi = 3.14159265358979;
  const int steps = 20;
  printf("lateral creep, load (N), force_x, force_y (N), moment_z (N m)\n");
  for (int k = 0; k <= steps; ++k) {
    const double phase = 2.0 * pi * k / steps;
    const double lateral = 2e-3 * sin(phase), load = 90e3 + 10e3 * cos(phase);
    wheelrail_forces forces;
    if ((code = wheelrail_set_creepages(contact, 5e-4, lateral, 0.1)) != WHEELRAIL_OK
        || (code = wheelrail_set_load(contact, load)) != WHEELRAIL_OK
        || (code = wheelrail_step(contact)) != WHEELRAIL_OK
        || (code = wheelrail_get_forces(contact, &forces)) != WHEELRAIL_OK)
      return fail(contact, code);
    printf("%9.6f %8.0f %9.1f %9.1f %8.2f\n", lateral, load, forces.force_x, forces.force_y,
           forces.moment_z);
  }
  wheelrail_free(contact);
  return WHEELRAIL_OK;
}
