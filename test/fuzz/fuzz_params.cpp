#include "fuzz/fuzz_params.h"

#include <cstring>
#include <limits>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace fuzz
{
namespace
{
constexpr double kReals[] = { 0.0,
                              0.5,
                              0.6,
                              1.0,
                              2.0,
                              6.0,
                              12.0,
                              20.0,
                              50.0,
                              100.0,
                              200.0,
                              254.0,
                              255.0,
                              1023.0,
                              4095.0,
                              65535.0,
                              -1.0,
                              1e300,
                              std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity() };
constexpr int kIntegers[] = { 0, 1, 2, 3, 4, 5, 7, 16, 40, 100, 1000, 65535, -1, std::numeric_limits<int>::max() };
constexpr const char* kWords[] = { "auto",
                                   "u",
                                   "v",
                                   "red",
                                   "green",
                                   "blue",
                                   "max",
                                   "gaussian",
                                   "sobel",
                                   "sound",
                                   "literal",
                                   "luminance",
                                   "maximum_likelihood",
                                   "least_squares",
                                   "",
                                   "nonsense" };

/// Tries values until one is accepted; once in a while keeps one that is not.
class Mutator
{
public:
  Mutator(Bytes& bytes, StripeParams& params) : bytes_(bytes), params_(params) {}

  void operator()(const char* /*name*/, double& value)
  {
    change(value, [this] { return bytes_.oneIn(2) ? bytes_.pick(kReals) : bytes_.real(0.0, 30.0); });
  }
  void operator()(const char* /*name*/, int& value)
  {
    change(value, [this] { return bytes_.oneIn(4) ? bytes_.pick(kIntegers) : bytes_.between(0, 20); });
  }
  void operator()(const char* /*name*/, bool& value) { value = bytes_.oneIn(2); }
  void operator()(const char* name, std::string& value)
  {
    if (std::strcmp(name, "method") != 0)
      change(value, [this] { return std::string(bytes_.pick(kWords)); });
  }

private:
  template <class Value, class Draw>
  void change(Value& value, Draw&& draw)
  {
    if (!bytes_.oneIn(3))
      return;
    const Value before = value;
    for (int attempt = 0; attempt < 8; ++attempt)
    {
      value = draw();
      try
      {
        params_.validate();
        return;
      }
      catch (const ConfigError&)
      {
        if (bytes_.oneIn(100))
          return;
      }
    }
    value = before;
  }

  Bytes& bytes_;
  StripeParams& params_;
};
}  // namespace

StripeParams readParams(Bytes& bytes)
{
  StripeParams params;
  params.visit(Mutator(bytes, params));
  return params;
}
}  // namespace fuzz
}  // namespace weld_profiler
