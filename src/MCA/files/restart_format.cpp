// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/restart_format.h"

#include "laws/interface_words.h"
#include "laws/linking.h"
#include "shared/plain_number.h"
#include "shared/printable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace mca {

namespace {

// FNV-1a
constexpr std::uint64_t sumBegin = 14695981039346656037ULL, sumFactor = 1099511628211ULL;

unsigned long long checksum(const std::string &text)
{
  return mca::checksum(text.data(), text.size());
}

// a number of events or rows: whole, and exact as a double
bool isCount(double value)
{
  constexpr double largest = 9007199254740992.0; // 2^53
  return value == std::floor(value) && std::abs(value) <= largest;
}

} // namespace

RestartError::RestartError(const std::string &line) : std::runtime_error(mcawr::printable(line)) {}

unsigned long long checksum(const void *bytes, std::size_t n)
{
  std::uint64_t sum = sumBegin;
  for (const auto *c = static_cast<const unsigned char *>(bytes); n > 0; c++, n--)
    sum = (sum ^ *c) * sumFactor;
  return sum;
}

// ---- the whole file

namespace {
// what stands before the checksum of a file: another number for another content
constexpr std::array<char, 16> sealMark = {"mca-restart 3:\n"};

// of all bytes from the present place on, but for those of the checksum itself
std::uint64_t checksumOf(FILE *fp, long hole)
{
  std::vector<unsigned char> bytes(1 << 20); // whole words
  std::uint64_t sum = sumBegin, length = 0;
  for (std::size_t n = 0; (n = fread(bytes.data(), 1, bytes.size(), fp)) > 0; length += n) {
    const std::size_t words = (n + sizeof(sum) - 1) / sizeof(sum);
    std::fill_n(bytes.begin() + static_cast<long>(n), words * sizeof(sum) - n, 0);
    for (long k = 0; k < static_cast<long>(sizeof(sum)); k++)
      if (const long at = hole + k - static_cast<long>(length);
          at >= 0 && at < static_cast<long>(n))
        bytes[at] = 0;
    for (std::size_t k = 0; k < n; k += sizeof(sum)) {
      std::uint64_t word;
      std::memcpy(&word, &bytes[k], sizeof(word));
      sum = (sum ^ word) * sumFactor; // both steps can be undone: no flip is lost
      sum ^= sum >> 32;
    }
  }
  sum = (sum ^ length) * sumFactor;
  return sum == 0 ? 1 : sum; // 0: the file was not finished
}
} // namespace

void FileSeal::keepPlace(FILE *fp)
{
  const std::uint64_t none = 0;
  fwrite(sealMark.data(), 1, sealMark.size(), fp);
  place_ = ftell(fp);
  fwrite(&none, sizeof(none), 1, fp);
}

bool FileSeal::close(const std::string &path) const
{
  FILE *fp = fopen(path.c_str(), "r+b");
  if (!fp)
    return false;
  const std::uint64_t sum = checksumOf(fp, place_);
  const bool good =
      !ferror(fp) && fseek(fp, place_, SEEK_SET) == 0 && fwrite(&sum, sizeof(sum), 1, fp) == 1;
  return fclose(fp) == 0 && good;
}

std::string FileSeal::problem(FILE *fp)
{
  std::array<char, sealMark.size()> mark = {};
  std::uint64_t sum = 0;
  const bool marked = fread(mark.data(), 1, mark.size(), fp) == mark.size() && mark == sealMark;
  const long place = ftell(fp);
  if (!marked || fread(&sum, sizeof(sum), 1, fp) != 1)
    return "Restart file is damaged, or of another version of pair_style mca";
  if (sum == 0)
    return "Restart file is damaged: it was not written to its end, and has no checksum";
  if (fseek(fp, 0, SEEK_SET) != 0 || checksumOf(fp, place) != sum ||
      fseek(fp, place + static_cast<long>(sizeof(sum)), SEEK_SET) != 0)
    return "Restart file is damaged or truncated: it does not match its checksum";
  return "";
}

// ---- blocks of text

void writeBlock(FILE *fp, const std::string &text)
{
  const BlockHead head = {text.size(), checksum(text)};
  fwrite(&head, sizeof(head), 1, fp);
  fwrite(text.data(), 1, text.size(), fp);
}

std::optional<std::string> readBlock(FILE *fp)
{
  BlockHead head = {0, 0};
  if (fread(&head, sizeof(head), 1, fp) != 1 || head.length >= longestBlock)
    return std::nullopt;
  std::string text(head.length, ' ');
  if (fread(text.data(), 1, text.size(), fp) != text.size() || checksum(text) != head.sum)
    return std::nullopt;
  return text;
}

void writeFixBlock(FILE *fp, const std::string &text)
{
  const int size = static_cast<int>(sizeof(BlockHead) + text.size());
  fwrite(&size, sizeof(size), 1, fp);
  writeBlock(fp, text);
}

std::optional<std::string> fixBlockIn(const char *bytes, std::size_t available)
{
  BlockHead head;
  if (available < sizeof(head))
    return std::nullopt;
  std::memcpy(&head, bytes, sizeof(head));
  if (head.length > available - sizeof(head))
    return std::nullopt;
  std::string text(bytes + sizeof(head), head.length);
  if (checksum(text) != head.sum)
    return std::nullopt;
  return text;
}

std::string exactText(const std::vector<double> &values)
{
  std::string text;
  for (const double value : values)
    text += mcawr::numberWord(value, 17) + " ";
  return text;
}

std::vector<double> numbersIn(const std::string &text, std::optional<std::size_t> n,
                              const char *what)
{
  const std::string where = std::string("Restart file is damaged: the block of ") + what + " has ";
  std::istringstream in(text);
  std::vector<double> values;
  for (std::string word; in >> word;) {
    const auto value = mcawr::plainNumber(word);
    if (!value)
      throw RestartError(where + "'" + word + "' for a finite number");
    values.push_back(*value);
  }
  if (n && values.size() != *n)
    throw RestartError(where + std::to_string(values.size()) + " numbers, not " +
                       std::to_string(*n));
  return values;
}

// ---- what blocks hold

std::string textOf(const PairSettings &settings)
{
  std::string text = exactText({settings.thickness, settings.cutoff}) + settings.packing->name;
  for (const auto &word : settings.laws.words())
    text += " " + word;
  return text + " ";
}

PairSettings settingsIn(const std::string &text)
{
  std::istringstream in(text);
  std::string thickness, cutoff, packing;
  in >> thickness >> cutoff >> packing;
  PairSettings settings;
  settings.packing = findPacking(packing.c_str());
  const auto h = mcawr::plainNumber(thickness), cut = mcawr::plainNumber(cutoff);
  if (!settings.packing || !h || *h < 0.0 || !cut || *cut < 0.0)
    throw RestartError("Restart file is damaged: pair_style mca: thickness " + thickness +
                       ", cutoff " + cutoff + ", packing " + packing);
  settings.thickness = *h;
  settings.cutoff = *cut;
  std::vector<std::string> words;
  for (std::string word; in >> word;)
    words.push_back(word);
  const std::string problem = settings.laws.parse(words);
  if (!problem.empty())
    throw RestartError("Restart file: pair_style mca: " + problem);
  return settings;
}

std::string textOf(const std::vector<Material> &materials)
{
  std::vector<double> values;
  for (const Material &material : materials)
    for (const auto &q : materialQuantities())
      values.push_back(material.*q.value);
  return exactText(values);
}

std::vector<Material> materialsIn(const std::string &text, std::size_t count)
{
  const auto &quantities = materialQuantities();
  const std::vector<double> values =
      numbersIn(text, count * quantities.size(), "pair_coeff of mca");
  std::vector<Material> materials(count);
  auto value = values.begin();
  for (std::size_t k = 0; k < count; k++) {
    for (const auto &q : quantities)
      materials[k].*q.value = *value++;
    if (const std::string problem = checkMaterial(materials[k]); !problem.empty())
      throw RestartError("Restart file is damaged: material of type " + std::to_string(k + 1) +
                         ": " + problem);
  }
  return materials;
}

// types, number of words, words
std::string textOfInterfaces(const Interfaces &interfaces)
{
  std::string text;
  for (const auto &[types, interface] : interfaces) {
    const std::vector<std::string> words = wordsOf(interface);
    for (const auto number : {std::size_t(types.first), std::size_t(types.second), words.size()})
      text += std::to_string(number) + " ";
    for (const std::string &word : words)
      text += word + " ";
  }
  return text;
}

Interfaces interfacesIn(const std::string &text, int types, const LawSet &laws)
{
  const std::string where = "Restart file is damaged: the block of pair_coeff interface has ";
  Interfaces all;
  std::istringstream in(text);
  for (std::string first; in >> first;) {
    std::string second, count;
    in >> second >> count;
    const auto i = mcawr::plainNumber(first), j = mcawr::plainNumber(second),
               n = mcawr::plainNumber(count);
    const auto isType = [types](const auto &t) {
      return t && isCount(*t) && *t >= 1 && *t <= types;
    };
    if (!isType(i) || !isType(j) || *i > *j || !n || !isCount(*n) || *n < 0)
      throw RestartError(where + "'" + first + " " + second + " " + count +
                         "' for two types and a number of words");
    std::vector<std::string> words;
    for (std::string word; words.size() < static_cast<std::size_t>(*n) && in >> word;)
      words.push_back(word);
    Interface interface;
    if (const std::string problem = readInterface(words, laws, interface); !problem.empty())
      throw RestartError(where + problem);
    all[{static_cast<int>(*i), static_cast<int>(*j)}] = interface;
  }
  return all;
}

// The numbers of a block in their order.
static constexpr double DriveSums::*driveSums[] = {
    &DriveSums::startHeight,  &DriveSums::displacement, &DriveSums::work,
    &DriveSums::shearSum,     &DriveSums::normalSum,    &DriveSums::samples,
    &DriveSums::brokenBefore, &DriveSums::formedBefore};

std::string textOf(const DriveState &s)
{
  std::vector<double> values;
  for (const auto sum : driveSums)
    values.push_back(s.sums.*sum);
  values.push_back(static_cast<double>(s.rows.number));
  values.push_back(static_cast<double>(s.rows.last));
  return exactText(values);
}

DriveState driveStateIn(const std::string &text)
{
  constexpr std::size_t count = std::size(driveSums);
  const std::vector<double> v = numbersIn(text, count + 2, "fix mca/drive");
  DriveState s;
  for (std::size_t k = 0; k < count; k++)
    s.sums.*driveSums[k] = v[k];
  // links over a periodic face count half on either side, so that events need not be whole
  const double samples = s.sums.samples, number = v[count], last = v[count + 1];
  if (!isCount(samples) || samples < 0.0 || !isCount(number) || number < -1.0 || !isCount(last))
    throw RestartError("Restart file is damaged: the block of fix mca/drive has " +
                       exactText({samples, number, last}) +
                       "for numbers of steps, rows and a step");
  s.rows = {static_cast<long long>(number), static_cast<long long>(last)};
  return s;
}

// ---- records of automata

std::optional<Record> recordNumber(const double *values, std::size_t size, int number)
{
  const double *const end = values + size;
  for (;; number--) {
    const double length = values < end ? values[0] : 0.0;
    if (!(length >= 2.0 && length <= static_cast<double>(end - values)) ||
        length != std::floor(length))
      return std::nullopt;
    if (number == 0)
      return Record{values, static_cast<std::size_t>(length) - 1};
    values += static_cast<std::size_t>(length);
  }
}

bool isStateRecord(const Record &record, std::size_t states)
{
  return record.size == 1 + states &&
         std::all_of(record.values + 1, record.values + record.size,
                     [](double value) { return std::isfinite(value); });
}

bool isPartnerRecord(const Record &record, std::size_t values)
{
  const std::size_t each = 1 + values;
  if (record.size < 2 || (record.size - 2) % each != 0)
    return false;
  const std::size_t partners = (record.size - 2) / each;
  if (record.values[1] != static_cast<double>(partners))
    return false;
  for (const double *partner = record.values + 2; partner < record.values + record.size;
       partner += each) {
    if (!std::all_of(partner + 1, partner + each, [](double v) { return std::isfinite(v); }) ||
        !link::isKind(partner[1]))
      return false;
    std::int64_t id;
    std::memcpy(&id, partner, sizeof(id));
    if (id < 1)
      return false;
  }
  return true;
}

} // namespace mca
