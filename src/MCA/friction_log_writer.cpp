// SPDX-License-Identifier: GPL-2.0-or-later
#include "friction_log_writer.h"

#include "shared/friction_log_format.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <unistd.h>

namespace mca {

namespace format = mcawr::friction_log;

FrictionLogWriter::~FrictionLogWriter()
{
  close();
}

void FrictionLogWriter::close()
{
  if (file_)
    std::fclose(file_);
  file_ = nullptr;
}

[[noreturn]] static void fail(const std::string &what, const std::string &path)
{
  throw std::runtime_error("cannot " + what + " friction log " + path + ": " +
                           std::strerror(errno));
}

// The log appears whole: written beside, then renamed over what stood there; then open to append.
void FrictionLogWriter::replaceBy(const std::string &text)
{
  const std::string beside = path_ + ".tmp";
  std::FILE *out = std::fopen(beside.c_str(), "w");
  if (!out)
    fail("write", path_);
  const bool written = std::fwrite(text.data(), 1, text.size(), out) == text.size() &&
                       std::fflush(out) == 0 && fsync(fileno(out)) == 0;
  std::fclose(out);
  if (!written || std::rename(beside.c_str(), path_.c_str()) != 0) {
    std::remove(beside.c_str());
    fail("write", path_);
  }
  file_ = std::fopen(path_.c_str(), "a");
  if (!file_)
    fail("append to", path_);
}

// YAML 1.1 takes a number with an exponent for text unless it has a point
static std::string number(double value)
{
  std::ostringstream text;
  text.precision(12);
  text << value;
  std::string word = text.str();
  const auto exponent = word.find('e');
  if (exponent != std::string::npos && word.find('.') == std::string::npos)
    word.insert(exponent, ".0");
  return word;
}

namespace {

/// One line of the head, "# NAME: {KEY: VALUE, ...}".
class Section {
 public:
  explicit Section(const std::string &name) : line_(std::string(format::headMark) + " " + name) {}

  void add(const std::string &key, const std::string &value)
  {
    line_ += (empty_ ? ": {" : ", ") + key + ": " + value;
    empty_ = false;
  }
  void add(const format::HeadNumber &what, double value) { add(what.key, number(value)); }
  void add(const format::HeadNumber &what, long long value)
  {
    add(what.key, std::to_string(value));
  }

  std::string line() const { return line_ + (empty_ ? ": {}\n" : "}\n"); }

 private:
  std::string line_;
  bool empty_ = true;
};

std::string materialLine(const Material &m, const Units &u)
{
  Section section(format::section::material);
  section.add(format::head::youngsModulus, m.youngsModulus * u.stress);
  section.add(format::head::poissonsRatio, m.poissonsRatio);
  section.add(format::head::density, m.density * u.density());
  section.add(format::head::elasticLimit, m.sigmaY1() * u.stress);
  section.add(format::head::yieldStrength, m.sigmaY2() * u.stress);
  section.add(format::head::yieldStrain, m.yieldStrain);
  section.add(format::head::strength, m.strength * u.stress);
  section.add(format::head::breakingStrain, m.breakingStrain);
  section.add(format::head::viscosity, m.viscosity * u.viscosity());
  return section.line();
}

std::string headOf(const LogHeader &h, const Units &u)
{
  namespace names = format::section;
  Section program(names::program), units(names::units), loading(names::loading),
      geometry(names::geometry), laws(names::laws), run(names::run);
  program.add("name", "mca-wheelrail");
  program.add("version", MCA_VERSION);
  program.add("lammps", std::to_string(h.lammpsVersion));
  for (const auto &[quantity, unit] : format::units)
    units.add(quantity, unit);
  loading.add(format::head::pressure, h.pressure * u.stress);
  loading.add(format::head::velocity, h.velocity * u.velocity());
  geometry.add(format::head::width, h.width * u.length);
  geometry.add(format::head::thickness, h.thickness * u.length);
  geometry.add(format::head::diameter, h.material.diameter * u.length);
  geometry.add(format::packingKey, h.packing);
  geometry.add(format::head::automata, h.automata);
  for (size_t k = 0; k + 1 < h.laws.size(); k += 2)
    laws.add(h.laws[k], h.laws[k + 1]);
  run.add(format::head::timestep, h.timestep * u.time);
  run.add(format::head::every, h.every);
  run.add(format::head::seed, h.seed);
  return format::formatLine() + "\n" + program.line() + units.line() + materialLine(h.material, u) +
         loading.line() + geometry.line() + laws.line() + run.line();
}

} // namespace

void FrictionLogWriter::begin(const std::string &path, const LogHeader &header, const Units &units)
{
  close();
  path_ = path;
  replaceBy(headOf(header, units) + format::columnLine() + "\n");
}

void FrictionLogWriter::resume(const std::string &path, long long step)
{
  close();
  path_ = path;
  std::ifstream in(path);
  if (!in)
    fail("continue", path);
  std::string kept, line;
  if (!std::getline(in, line) || line != format::formatLine())
    throw std::runtime_error("cannot continue friction log " + path + ": its first line is not '" +
                             format::formatLine() + "'");
  kept = line + "\n";
  while (std::getline(in, line)) {
    const bool isRow = !line.empty() && line[0] >= '0' && line[0] <= '9';
    const bool cutShort = in.eof(); // no newline: the machine stopped while it was written
    if (isRow && (cutShort || std::strtoll(line.c_str(), nullptr, 10) > step))
      continue;
    kept += line + "\n";
  }
  replaceBy(kept);
}

void FrictionLogWriter::write(const LogRow &r)
{
  std::fprintf(file_, "%lld %.10g %.10g %.8g %.8g %.8g %.10g %.10g %.10g %.8g\n", r.step, r.time,
               r.displacement, r.shearStress, r.normalStress, r.mu, r.links, r.broken, r.formed,
               r.gap);
  if (std::fflush(file_) != 0)
    fail("append to", path_);
}

} // namespace mca
