#include "weld/case_file.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <type_traits>

#include "weld_profiler/core/atomic_file.h"

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
const char* const kFormat = "weld_accuracy_3";
const char* const kNoVerdict = "-";

std::string text(double value)
{
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.10g", value);
  return buffer;
}

/// FNV-1a.
void addFile(const std::string& path, std::uint64_t& hash)
{
  std::ifstream file(path, std::ios::binary);
  for (std::istreambuf_iterator<char> at(file), end; at != end; ++at)
    hash = (hash ^ static_cast<unsigned char>(*at)) * 0x100000001B3ULL;
}

/// Word by word; a NaN is a number here, which `stream >> double` does not know.
class Reader
{
public:
  explicit Reader(std::istream& in) : in_(in) {}

  std::string word()
  {
    std::string word;
    good_ = static_cast<bool>(in_ >> word) && good_;
    return word;
  }

  double number()
  {
    const std::string text = word();
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    good_ = good_ && !text.empty() && *end == '\0';
    return value;
  }

  void expect(const char* wanted) { good_ = word() == wanted && good_; }
  bool good() const { return good_; }

private:
  std::istream& in_;
  bool good_ = true;
};

void writeSection(const SectionCase& section, std::ostream& out)
{
  const auto verdict = [](const std::string& name) { return name.empty() ? kNoVerdict : name.c_str(); };
  out << "section " << text(section.s) << ' ' << static_cast<int>(section.stature) << ' ' << verdict(section.verdict)
      << ' ' << verdict(section.true_verdict) << ' ' << text(section.clearance);
  for (const Deviation& size : section.sizes)
    out << ' ' << text(size.value) << ' ' << text(size.sigma) << ' ' << text(size.truth);
  out << '\n';
}

SectionCase readSection(Reader& reader)
{
  SectionCase section;
  reader.expect("section");
  section.s = reader.number();
  section.stature = static_cast<Stature>(static_cast<int>(reader.number()));
  for (std::string* verdict : { &section.verdict, &section.true_verdict })
  {
    *verdict = reader.word();
    if (*verdict == kNoVerdict)
      verdict->clear();
  }
  section.clearance = reader.number();
  for (Deviation& size : section.sizes)
    size.value = reader.number(), size.sigma = reader.number(), size.truth = reader.number();
  return section;
}
}  // namespace

std::string buildMark()
{
  std::set<std::string> files = { "/proc/self/exe" };
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
  {
    const std::size_t path = line.find('/');
    if (path != std::string::npos && line.find("libweld_profiler") != std::string::npos)
      files.insert(line.substr(path));
  }
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const std::string& file : files)
    addFile(file, hash);
  char buffer[20];
  std::snprintf(buffer, sizeof buffer, "%016llx", static_cast<unsigned long long>(hash));
  return buffer;
}

void saveCase(const WeldCase& weld, const std::string& path, const std::string& mark)
{
  std::ostringstream out;
  out << kFormat << ' ' << mark << "\nseed " << weld.seed << "\nkind " << weld.kind << ' ' << weld.measured_kind
      << '\n';
  visitNumbers(weld, [&](const char* name, const auto& value)
               { out << name << ' ' << text(static_cast<double>(value)) << '\n'; });
  out << "count " << weld.sections.size() << '\n';
  for (const SectionCase& section : weld.sections)
    writeSection(section, out);
  out << "end\n";
  writeWholeFile(path, out.str());
}

std::optional<WeldCase> loadCase(const std::string& path, const std::string& mark)
{
  std::ifstream in(path);
  if (!in)
    return std::nullopt;
  Reader reader(in);
  reader.expect(kFormat);
  reader.expect(mark.c_str());
  if (!reader.good())
    return std::nullopt;
  WeldCase weld;
  reader.expect("seed");
  weld.seed = std::strtoull(reader.word().c_str(), nullptr, 10);
  reader.expect("kind");
  weld.kind = reader.word();
  weld.measured_kind = reader.word();
  visitNumbers(weld,
               [&](const char* name, auto& value)
               {
                 reader.expect(name);
                 value = static_cast<std::decay_t<decltype(value)>>(reader.number());
               });
  reader.expect("count");
  const double count = reader.number();
  for (int i = 0; i < count && reader.good(); ++i)
    weld.sections.push_back(readSection(reader));
  reader.expect("end");
  return reader.good() ? std::optional<WeldCase>(std::move(weld)) : std::nullopt;
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
