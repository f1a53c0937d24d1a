// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_specification.h"

namespace wheelrail {
namespace {

/// Drives in the order of the results: spin, lateral, longitudinal.
std::vector<PatchDrive> drivesOf(const PatchSpecification &asked)
{
  const bool givesX = !asked.forceX.empty(), givesY = !asked.forceY.empty();
  std::vector<PatchDrive> drives;
  for (double spin : asked.spin)
    for (double y : givesY ? asked.forceY : asked.lateral)
      for (double x : givesX ? asked.forceX : asked.creep) {
        PatchDrive drive;
        drive.creepage.phi = spin;
        (givesX ? drive.forceX.emplace(0.0) : drive.creepage.xi) = x;
        (givesY ? drive.forceY.emplace(0.0) : drive.creepage.eta) = y;
        drives.push_back(drive);
      }
  return drives;
}

std::vector<PatchTask> staticTasks(const PatchSpecification &asked)
{
  std::vector<PatchTask> tasks;
  for (double ratio : asked.forceRatio) {
    PatchTask task{};
    task.forceRatio = ratio;
    tasks.push_back(task);
  }
  for (const auto &shift : asked.shift) {
    PatchTask task{};
    task.drive.creepage = {shift[0], shift[1], asked.twist};
    tasks.push_back(task);
  }
  if (!tasks.empty())
    return tasks;
  for (const PatchDrive &drive : drivesOf(asked)) {
    PatchTask task{};
    task.drive = drive;
    tasks.push_back(task);
  }
  return tasks;
}

} // namespace

int fieldNumber(const FieldPlace &place, int points)
{
  return place.point + place.instant * points;
}

FieldPlace fieldPlace(int number, int points)
{
  return {(number - 1) % points + 1, (number - 1) / points};
}

std::vector<PatchTask> patchTasks(const PatchSpecification &asked)
{
  const std::size_t contacts = asked.roughness.surfaces() * asked.contact.load.size();
  std::vector<PatchTask> tasks;
  for (std::size_t contact = 0; contact < contacts; ++contact)
    if (asked.mode == PatchMode::Static) {
      for (PatchTask task : staticTasks(asked)) {
        task.contact = contact;
        tasks.push_back(task);
      }
    } else {
      for (double speed : asked.speed)
        for (const PatchDrive &drive : drivesOf(asked))
          tasks.push_back({contact, speed, drive, std::nullopt});
    }
  return tasks;
}

} // namespace wheelrail
