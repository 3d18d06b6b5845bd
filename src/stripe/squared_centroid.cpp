#include "method.h"

namespace weld_profiler
{
namespace
{
/// The paper's initial point, Eq. 4, taken as the result. See ColumnCentroid.
class SquaredCentroid : public MethodBase
{
public:
  using MethodBase::MethodBase;
};
}  // namespace

std::unique_ptr<const StripeExtractor> makeSquaredCentroid(const StripeParams& params)
{
  return std::make_unique<SquaredCentroid>(params);
}
}  // namespace weld_profiler
