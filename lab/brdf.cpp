// Brdf: pairs of directions as rows of the kernel that evaluates lobes alone.
#include "lab/brdf.h"

#include <algorithm>

#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "host/brdf_name.h"
#include "host/device_opening.h"
#include "host/row_band.h"
#include "host/self_test.h"

namespace relume {
namespace {

constexpr std::size_t rows_at_once = 1 << 18;  // some 60 MB of planes

}  // namespace

PreciseCosines cosines_of(const DirectionPair& pair) {
  const glm::dvec3 sum = pair.l + pair.v, mirrored{-pair.v.x, -pair.v.y, pair.v.z}, chord = pair.l - mirrored;
  PreciseCosines c{};
  c.n_l = pair.l.z;
  c.n_v = pair.v.z;
  c.l_v = pair.l.x * pair.v.x + pair.l.y * pair.v.y + pair.l.z * pair.v.z;
  c.across2 = sum.x * sum.x + sum.y * sum.y;
  c.along2 = sum.z * sum.z;
  c.sum2 = c.across2 + c.along2;
  c.tan2_h = c.across2 < 1e30 * c.along2 ? c.across2 / c.along2 : 1e30;  // as in the kernels
  c.chord2 = chord.x * chord.x + chord.y * chord.y + chord.z * chord.z;
  c.r_l = 1 - c.chord2 / 2;
  return c;
}

std::shared_ptr<Device> lab_device(const std::string& selector) { return open_device_or_twin(selector); }

Brdf::Brdf(const std::string& name, const std::vector<std::string>& set, std::shared_ptr<Device> device)
    : name_(name), material_(material_named(name)), device_(std::move(device)) {
  for (const std::string& assignment : set) set_parameter(material_, assignment);
  check(material_, name);
  const LayerFinder no_layers = [](const std::string& layer) -> RoleLayer {
    throw Error(ErrorKind::input, "--set: no layer \"" + printable(layer) + "\": a plot takes constants");
  };
  binding_ = std::make_unique<Binding>(material_, std::nullopt, name, no_layers, reading_);
  if (device_->info().name != "twin") self_test(*device_, binding_->programs().front());
}

std::vector<Reflectance> Brdf::reflectance(std::span<const DirectionPair> pairs) const {
  std::vector<Reflectance> values;
  values.reserve(pairs.size());
  for (std::size_t first = 0; first < pairs.size(); first += rows_at_once) {
    const std::span<const DirectionPair> some = pairs.subspan(first, std::min(rows_at_once, pairs.size() - first));
    std::vector<PreciseCosines> cosines(some.size());
    std::transform(some.begin(), some.end(), cosines.begin(), cosines_of);
    const Planes out = RowBand(cosines).evaluate(*device_, *binding_);
    const auto colour = [&](int plane, std::size_t i) { return glm::dvec3(out.plane(plane)[i], out.plane(plane + 1)[i], out.plane(plane + 2)[i]); };
    for (std::size_t i = 0; i < some.size(); ++i) values.push_back({colour(0, i), colour(3, i)});
  }
  return values;
}

}  // namespace relume
