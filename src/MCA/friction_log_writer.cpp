#include "friction_log_writer.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <unistd.h>

namespace mca {

static constexpr const char *format = "# format: mca-friction 1";

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

static std::string joined(const std::vector<std::string> &pairs)
{
  std::string all;
  for (size_t k = 0; k + 1 < pairs.size(); k += 2)
    all += (k ? ", " : "") + pairs[k] + ": " + pairs[k + 1];
  return all;
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

void FrictionLogWriter::begin(const std::string &path, const LogHeader &h, const Units &u)
{
  close();
  path_ = path;
  const Material &m = h.material;
  std::ostringstream text;
  text << format << "\n"
       << "# program: {name: mca-wheelrail, version: " << MCA_VERSION
       << ", lammps: " << h.lammpsVersion << "}\n"
       << "# units: {time: ns, length: nm, stress: MPa, velocity: m/s, density: kg/m3, "
          "viscosity: Pa s}\n"
       << "# material: {youngs_modulus: " << number(m.youngs_modulus * u.stress)
       << ", poissons_ratio: " << number(m.poissons_ratio)
       << ", density: " << number(m.density * u.density())
       << ", elastic_limit: " << number(m.sigmaY1() * u.stress)
       << ", yield_strength: " << number(m.sigmaY2() * u.stress)
       << ", yield_strain: " << number(m.yield_strain)
       << ", strength: " << number(m.strength * u.stress)
       << ", breaking_strain: " << number(m.breaking_strain)
       << ", viscosity: " << number(m.viscosity * u.viscosity()) << "}\n"
       << "# loading: {pressure: " << number(h.pressure * u.stress)
       << ", velocity: " << number(h.velocity * u.velocity()) << "}\n"
       << "# geometry: {width: " << number(h.width * u.length)
       << ", thickness: " << number(h.thickness * u.length)
       << ", diameter: " << number(m.diameter * u.length)
       << ", packing: hex, automata: " << h.automata << "}\n"
       << "# laws: {" << joined(h.laws) << "}\n"
       << "# run: {timestep: " << number(h.timestep * u.time) << ", every: " << h.every
       << ", seed: " << h.seed << "}\n"
       << "step time displacement shear_stress normal_stress mu links broken formed gap\n";
  replaceBy(text.str());
}

void FrictionLogWriter::resume(const std::string &path, long long step)
{
  close();
  path_ = path;
  std::ifstream in(path);
  if (!in)
    fail("continue", path);
  std::string kept, line;
  if (!std::getline(in, line) || line != format)
    throw std::runtime_error("cannot continue friction log " + path + ": its first line is not '" +
                             format + "'");
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
