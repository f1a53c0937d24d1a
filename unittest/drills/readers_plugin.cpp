// SPDX-License-Identifier: GPL-2.0-or-later
#include "readers.h"

#include "memory_file.h"

#include "core/automaton_states.h"
#include "core/link_list.h"
#include "files/friction_log_writer.h"
#include "files/links_text.h"
#include "files/material_file.h"
#include "files/restart_format.h"
#include "laws/law_set.h"
#include "laws/linking.h"
#include "shared/printable.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace {

/// Turns what readers of the plugin throw into Refused.
std::function<void(const std::string &)> refusing(void (*read)(const std::string &))
{
  return [=](const std::string &bytes) {
    try {
      read(bytes);
    } catch (const mca::MaterialError &error) {
      throw Refused(error.what());
    } catch (const mca::LinksError &error) {
      throw Refused(error.what());
    } catch (const mca::RestartError &error) {
      throw Refused(error.what());
    }
  };
}

const mca::Material &steel()
{
  static const mca::Material steel = [] {
    std::ostringstream text;
    text << std::ifstream(std::string(PROJECT_SOURCE) + "/potentials/steel.mca").rdbuf();
    return mca::readMaterial(text.str(), "steel.mca", "nano");
  }();
  return steel;
}

mca::Material checked(const mca::Material &material)
{
  const std::string problem = mca::checkMaterial(material);
  require(problem.empty(), problem);
  return material;
}

void readPotential(const std::string &bytes)
{
  std::optional<double> temperature;
  if (bytes.find("\ntemperature") != std::string::npos)
    temperature = 450.0;
  for (const char *units : {"nano", "si"})
    checked(mca::readMaterial(bytes, "drill.mca", units, temperature));
}

std::vector<std::string> wordsOf(const std::string &text)
{
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  return words;
}

void readQuantities(const std::string &bytes)
{
  std::vector<std::string> words = wordsOf(bytes);
  mca::takeTemperature(words);
  checked(mca::overrideMaterial(steel(), words));
}

void readLaws(const std::string &bytes)
{
  mca::LawSet laws;
  const std::string problem = laws.parse(wordsOf(bytes));
  if (!problem.empty())
    throw Refused(mcawr::printable(problem)); // words of the input script, which LAMMPS shows too
  mca::LawSet again;
  require(again.parse(laws.words()).empty() && again.words() == laws.words(),
          "other laws when read again");
}

/// In memory: the writer waits for the disk.
std::string logPath()
{
  const std::string folder =
      std::filesystem::exists("/dev/shm") ? "/dev/shm" : std::filesystem::temp_directory_path();
  return folder + "/drill-" + std::to_string(::getpid());
}

mca::LogHeader logHeader()
{
  mca::LogHeader header = {};
  header.material = {206000, 0.3, 0.0078, 92, 0.554, 0.87, 0.015, 0.04, 410, 2.5};
  header.pressure = 15;
  header.velocity = 5;
  header.width = 100;
  header.thickness = 1;
  header.packing = "hex";
  header.automata = 560;
  header.laws = mca::LawSet().words();
  header.timestep = 5e-5;
  header.every = 1000;
  header.seed = 1;
  return header;
}

/// A log of five rows that may be continued.
std::string startedLog()
{
  const std::string path = logPath();
  mca::FrictionLogWriter log;
  log.begin(path, logHeader(), *mca::findUnits("nano"), 0, false);
  for (const double step : {1000.0, 2000.0, 3000.0, 4000.0, 5000.0}) {
    mca::LogRow row;
    row.step = step;
    row.time = 5e-5 * step;
    row.displacement = 2.5e-4 * step;
    row.shearStress = 7.5;
    row.normalStress = 15;
    row.mu = 0.5;
    row.links = 1500;
    row.broken = 4;
    row.formed = 5;
    row.gap = -0.1;
    log.write(row);
  }
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  std::filesystem::remove(path);
  return text.str();
}

/// A log that is continued: as readFrictionLog would take it, if it took the whole one.
void resumeLog(const std::string &bytes)
{
  static const std::string path = logPath();
  std::ofstream(path, std::ios::binary) << bytes;
  try {
    mca::FrictionLogWriter().resume(path, logHeader(), *mca::findUnits("nano"), 5000, {5, 5000});
  } catch (const std::runtime_error &error) {
    std::filesystem::remove(path);
    throw Refused(error.what());
  }
  std::filesystem::remove(path);
}

// ---- files of mca_links

const int planeState = mca::LinkList().stateSize(); ///< values of a pair in the plane
constexpr std::int64_t largestId = 2147483647;

/// As a run of two small blocks writes it: pairs of each kind, states, bonds.
std::string linksText()
{
  const double states[][4] = {
      {1, 1.25e-4, -3.5e-5, 2e-3}, {2, 0, 1.0 / 3.0, 0.1}, {-1, -2e-3, 7.5, 0}, {0, -1e-5, 0, 0}};
  std::string comments, bonds;
  int pair = 0;
  for (const auto &state : states) {
    comments += mca::pairLine(pair + 1, pair + 2, state, planeState, pair % 2 == 0);
    pair++;
  }
  for (const char *name : {"kappa", "theta", "links0", "spin_lag_z"})
    comments += mca::automatonLine(3, mca::stateNumber(name), 6.0 / 7.0);
  std::string text = mca::linksHead(
      "5 atoms\n1 atom types\n2 bonds\n2 bond types\n0 25 xlo xhi\n0 17 ylo yhi\n-0.5 0.5 zlo "
      "zhi\n",
      comments);
  text += "\nAtoms # hybrid\n\n";
  for (int id = 1; id <= 5; id++)
    text += std::to_string(id) + " 1 1.25 0.5 0 2.5 0.0078 0 0 0 0\n";
  return text + "\nBonds\n\n1 1 1 2\n2 2 2 3\n";
}

/// The section of another program's data file.
std::string bondsText()
{
  return "a data file\n\n4 atoms\n3 bonds\n\nMasses\n\n1 1.0\n\nBonds # of all kinds\n\n"
         "1 1 1 2\n2 2 2 3 # welded\n3 1 3 4\n\nAngles\n\n1 1 1 2 3\n";
}

bool isSame(const mca::Links &a, const mca::Links &b)
{
  return a.pairs == b.pairs && a.automata == b.automata;
}

/// Falsified, then sealed again: the parser behind the checksum.
void readLinks(const std::string &bytes)
{
  const mca::Links links = mca::linksIn(mca::sealedLinks(bytes), planeState, largestId);
  std::string comments;
  for (const auto &[ids, pair] : links.pairs) {
    require(ids.first >= 1 && ids.first < ids.second && ids.second <= largestId, "no pair of IDs");
    require(pair.state.size() == static_cast<std::size_t>(planeState) &&
                mca::link::isKind(pair.state[0]) &&
                std::all_of(pair.state.begin(), pair.state.end(),
                            [](double value) { return std::isfinite(value); }),
            "no state of a pair");
    comments += mca::pairLine(ids.first, ids.second, pair.state.data(), planeState, pair.original);
  }
  for (const auto &[id, values] : links.automata)
    for (const mca::Links::Value &value : values) {
      require(value.state >= 0 && value.state < mca::stateCount && std::isfinite(value.value),
              "no state of an automaton");
      comments += mca::automatonLine(id, value.state, value.value);
    }
  const std::string again = mca::sealedLinks(mca::linksHead("", comments));
  require(isSame(mca::linksIn(again, planeState, largestId), links), "other links when read again");
}

/// Falsified only: what is still a file of ours is as it was written.
void readSealedLinks(const std::string &bytes)
{
  static const mca::Links written =
      mca::linksIn(mca::sealedLinks(linksText()), planeState, largestId);
  const mca::Links links = mca::linksIn(bytes, planeState, largestId);
  const bool ours = bytes.find("# mca-links ") != std::string::npos ||
                    bytes.find("\n# checksum ") != std::string::npos;
  require(!ours || isSame(links, written), "other links than were written");
}

// ---- restart files

mca::PairSettings settings(const std::vector<std::string> &words, const char *packing)
{
  mca::PairSettings settings;
  settings.cutoff = 1.0 / 3.0;
  settings.packing = mca::findPacking(packing);
  require(settings.laws.parse(words).empty(), "bad laws");
  return settings;
}

mca::DriveState driveState()
{
  mca::DriveState drive;
  drive.sums.startHeight = 21.25;
  drive.sums.displacement = 1.0 / 3.0;
  drive.sums.work = 812.5;
  drive.sums.shearSum = 7.5;
  drive.sums.normalSum = -15.25;
  drive.sums.samples = 37;
  drive.sums.brokenBefore = -4;
  drive.sums.formedBefore = -2.5;
  drive.rows = {12, 1200};
  return drive;
}

void readSettings(const std::string &text)
{
  const mca::PairSettings settings = mca::settingsIn(text);
  require(std::isfinite(settings.thickness) && settings.thickness >= 0.0 &&
              std::isfinite(settings.cutoff) && settings.cutoff >= 0.0 && settings.packing,
          "no settings");
  const std::string again = mca::textOf(settings);
  require(mca::textOf(mca::settingsIn(again)) == again, "other settings when read again");
}

void readMaterials(const std::string &text)
{
  for (const mca::Material &material : mca::materialsIn(text, 2))
    require(mca::checkMaterial(material).empty(), "no material");
}

void readInterfaces(const std::string &text)
{
  const std::string again = mca::textOfInterfaces(mca::interfacesIn(text, 3, {}));
  require(mca::textOfInterfaces(mca::interfacesIn(again, 3, {})) == again, "other interfaces");
}

void readDrive(const std::string &text)
{
  const std::string again = mca::textOf(mca::driveStateIn(text));
  require(mca::textOf(mca::driveStateIn(again)) == again, "another state when read again");
}

/// A file as LAMMPS has it: something of its own, then the seal, the blocks of the pair style and
/// that of a fix, and its own end.
constexpr std::size_t before = 64; ///< bytes
constexpr std::size_t seal = 16 + 8;

std::string restartFile()
{
  static const MemoryFile file("restart");
  file.holding(std::string(before, 'L'));
  FILE *fp = fopen(file.path.c_str(), "r+b");
  fseek(fp, before, SEEK_SET);
  mca::FileSeal kept;
  kept.keepPlace(fp);
  mca::writeBlock(fp, mca::textOf(settings({"preset", "b"}, "hex")));
  mca::writeBlock(fp, mca::textOf({steel(), steel()}));
  mca::writeFixBlock(fp, mca::textOf(driveState()));
  fwrite("LammpS RestartT", 1, 16, fp);
  fclose(fp);
  require(kept.close(file.path), "no checksum");
  std::ostringstream text;
  text << std::ifstream(file.path, std::ios::binary).rdbuf();
  return text.str();
}

/// With the checksum of the block at this place right; the place behind it.
std::size_t mendBlock(std::string &bytes, std::size_t at)
{
  mca::BlockHead head;
  if (at > bytes.size() || bytes.size() - at < sizeof(head))
    return bytes.size();
  std::memcpy(&head, &bytes[at], sizeof(head));
  at += sizeof(head);
  if (head.length > bytes.size() - at)
    return bytes.size();
  head.sum = mca::checksum(&bytes[at], head.length);
  std::memcpy(&bytes[at - sizeof(head)], &head, sizeof(head));
  return at + head.length;
}

/// A file in memory with these bytes, at the place of its seal.
class OpenRestart {
 public:
  explicit OpenRestart(const std::string &path) : fp(fopen(path.c_str(), "rb"))
  {
    fseek(fp, before, SEEK_SET);
  }
  ~OpenRestart() { fclose(fp); }
  OpenRestart(const OpenRestart &) = delete;
  OpenRestart &operator=(const OpenRestart &) = delete;
  FILE *const fp;
};

/// The parts of a restart file as the plugin reads them; the block of the fix as LAMMPS hands it
/// over.
void readRestart(const std::string &path)
{
  const OpenRestart file(path);
  const std::string problem = mca::FileSeal::problem(file.fp);
  if (!problem.empty())
    throw Refused(problem);
  const auto block = [&](const std::optional<std::string> &text) {
    if (!text)
      throw Refused("a block does not match its checksum");
    return *text;
  };
  readSettings(block(mca::readBlock(file.fp)));
  readMaterials(block(mca::readBlock(file.fp)));
  int size = 0;
  if (fread(&size, sizeof(size), 1, file.fp) != 1 || size < 0 || size > (1 << 20))
    throw Refused("LAMMPS's own length");
  std::vector<char> memory(size); // exactly so much, for AddressSanitizer
  const std::size_t read = fread(memory.data(), 1, memory.size(), file.fp);
  readDrive(block(mca::fixBlockIn(memory.data(), read)));
}

/// Falsified, then sealed again, block by block and as a whole.
void readMendedRestart(const std::string &bytes)
{
  static const MemoryFile file("mended");
  if (bytes.size() < before + seal)
    throw Refused("cut before the seal");
  std::string mended = bytes;
  const std::size_t fix = mendBlock(mended, mendBlock(mended, before + seal));
  mendBlock(mended, fix + sizeof(int));
  file.holding(mended.substr(0, before));
  FILE *fp = fopen(file.path.c_str(), "r+b");
  fseek(fp, before, SEEK_SET);
  mca::FileSeal kept;
  kept.keepPlace(fp);
  fwrite(&mended[before + seal], 1, mended.size() - before - seal, fp);
  fclose(fp);
  require(kept.close(file.path), "no checksum");
  readRestart(file.path);
}

/// Falsified only: the good file, or refused.
void readSealedRestart(const std::string &bytes)
{
  static const MemoryFile file("sealed");
  static const std::string good = restartFile();
  readRestart(file.holding(bytes));
  require(bytes == good, "accepted, and not the good file");
}

const int partnerValues = mca::LinkList().storedSize(); ///< in the plane
constexpr int automaton = 7;                            ///< whose records they are

std::string bytesOf(const std::vector<double> &values)
{
  return {reinterpret_cast<const char *>(values.data()), values.size() * sizeof(double)};
}

/// The records of an automaton: five states, then three partners.
std::string records()
{
  std::vector<double> values = {7, 0.25, -1, 3e-5, 6, 1.0 / 3.0, 0};
  std::vector<double> partners = {0, 3};
  for (const std::int64_t id : {7, 8, 12}) {
    double bits;
    std::memcpy(&bits, &id, sizeof(bits));
    partners.push_back(bits);
    const double kind = id == 7 ? 0.0 : id == 8 ? 1.0 : -1.0;
    for (int m = 0; m < partnerValues; m++)
      partners.push_back(m == 0 ? kind : 0.1 * m * kind);
  }
  partners.push_back(0);
  partners[0] = static_cast<double>(partners.size());
  values.insert(values.end(), partners.begin(), partners.end());
  return bytesOf(values);
}

/// As fix neigh/history unpacks a record, which trusts its numbers.
void unpackPartners(const mca::Record &record)
{
  std::size_t m = 1;
  const int count = static_cast<int>(record.values[m++]);
  for (int n = 0; n < count; n++)
    m += 1 + partnerValues;
  require(count >= 0 && m == record.size, "a record that is read beyond its end");
}

/// Falsified, then with the right checksums: what a record may hold.
void readRecords(const std::string &bytes)
{
  std::vector<double> values(bytes.size() / sizeof(double)); // no more than there is
  if (!values.empty())
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
  for (int number = 0; number < 2; number++) {
    const auto place = mca::recordNumber(values.data(), values.size(), number);
    if (!place)
      throw Refused("a length that does not fit");
    values[place->values - values.data() + place->size] =
        mca::recordChecksum(place->values, place->size, automaton);
    const auto record = mca::checkedRecord(values.data(), values.size(), number, automaton);
    require(record.has_value(), "a checksum that is not its own");
    if (!(number == 0 ? mca::isStateRecord(*record, 5)
                      : mca::isPartnerRecord(*record, partnerValues)))
      throw Refused("another length, or no state");
    if (number == 1)
      unpackPartners(*record);
  }
}

} // namespace

std::vector<Reader> pluginReaders()
{
  return {
      {"potential", filesOf("potentials", ".mca"), refusing(readPotential)},
      {"pair_coeff",
       {"strength 92 youngs_modulus 2.06e5", "viscosity 0.41 diameter 2.5 density 7800"},
       refusing(readQuantities)},
      {"pair_style",
       {"preset a", "preset b plasticity isochoric flow contacts steps plain",
        "plane stress plasticity none",
        "fracture drucker-prager compressive_strength 1.5 link_work 2",
        "compressive_strength 3 fracture mohr-coulomb",
        "link 2.35 weld none heal "
        "none"},
       readLaws},
      {"resumed_log", {startedLog()}, resumeLog},
      {"links", {linksText(), bondsText()}, refusing(readLinks)},
      {"sealed_links", {mca::sealedLinks(linksText())}, refusing(readSealedLinks)},
      {"restart_laws",
       {mca::textOf(settings({"preset", "a"}, "hex")),
        mca::textOf(
            settings({"preset", "b", "plasticity", "isochoric", "flow", "contacts"}, "hex")),
        mca::textOf(settings({"link", "2.35", "weld", "none", "heal", "none"}, "fcc"))},
       refusing(readSettings)},
      {"restart_materials", {mca::textOf({steel(), steel()})}, refusing(readMaterials)},
      {"restart_interfaces",
       {"1 2 6 strength 30 breaking_strain 0.1 viscosity 0 2 2 4 link none weld 0.5 "},
       refusing(readInterfaces)},
      {"restart_drive", {mca::textOf(driveState())}, refusing(readDrive)},
      {"restart_records", {records()}, refusing(readRecords)},
      {"restart", {restartFile()}, refusing(readMendedRestart)},
      {"sealed_restart", {restartFile()}, refusing(readSealedRestart)},
  };
}
