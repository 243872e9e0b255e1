// The kernels over counting lanes: shaded with one light and with two, the difference is what a light costs.
#include "bench/operations.h"

#include <array>
#include <bit>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "gbuffer/error.h"
#include "host/frame.h"

namespace relume::bench {
namespace {

#include "bench/counting_lanes.h"
#include "kernels/shade.h"

void count(Kind kind, Operations& sum) {
  switch (kind) {
    case Kind::add:
      ++sum.add;
      break;
    case Kind::multiply:
      ++sum.multiply;
      break;
    case Kind::fused:
      ++sum.add;
      ++sum.multiply;
      ++sum.fused;
      break;
    case Kind::divide:
      ++sum.divide;
      break;
    case Kind::root:
      ++sum.root;
      break;
    case Kind::compare:
      ++sum.compare;
      break;
    case Kind::select:
      ++sum.select;
      break;
    case Kind::whole:
      ++sum.whole;
      break;
    case Kind::load:
      ++sum.loads;
      break;
    case Kind::constant:
    case Kind::free:
      break;
  }
}

/// How many of a node's operands are nodes themselves.
std::size_t operand_count(const Node& node) {
  if (node.kind == Kind::constant || node.kind == Kind::load) return 0;
  return node.kind == Kind::select || node.kind == Kind::fused ? 3 : 2;
}

/// The operations on which the stored results and branches depend. Nodes come after their operands, so one pass backwards finds them all.
Operations needed() {
  Operations sum;
  sum.stores = double(tape.stored.size());
  std::vector<bool> is_needed(tape.nodes.size());
  for (const std::vector<int>* const nodes : {&tape.stored, &tape.decided})
    for (const int node : *nodes) is_needed[std::size_t(node)] = true;
  for (std::size_t n = tape.nodes.size(); n-- > 0;) {
    if (!is_needed[n]) continue;
    const Node& node = tape.nodes[n];
    count(node.kind, sum);
    for (std::size_t k = 0; k < operand_count(node); ++k) is_needed[std::size_t(node.operands[k])] = true;
  }
  return sum;
}

Operations difference(Operations a, const Operations& b) {
  for (const auto member : {&Operations::add, &Operations::multiply, &Operations::divide, &Operations::root, &Operations::fused, &Operations::compare,
                            &Operations::select, &Operations::whole, &Operations::loads, &Operations::stores})
    a.*member -= b.*member;
  return a;
}

/// A pixel that shows a surface of the frame's program, near the middle.
int surface_pixel(const Frame& frame, const Planes& planes) {
  const float* program = planes.plane(frame.program_plane);
  for (int k = 0; k < frame.pixels; ++k)
    if (const int i = (frame.pixels / 2 + k) % frame.pixels; program[i] == float(frame.program)) return i;
  throw Error(ErrorKind::internal, "operations are counted on a frame that shows a surface");
}

/// The light moved to where the pixel's normal points, within its range, shining back. `aside`, different for two lights, makes all their numbers
/// different: equal ones would be worked out once.
LightRecord facing(LightRecord light, const Frame& frame, const Planes& planes, int pixel, float aside) {
  const float distance = light.range > 0 ? 0.9f * light.range : 2;
  for (int c = 0; c < 3; ++c) {
    const float n = planes.plane(frame.normal + c)[pixel], apart = aside * float(c + 1);
    light.position[c] = planes.plane(frame.position + c)[pixel] + distance * (n + apart);
    light.direction[c] = -n - apart;
    light.intensity[c] += apart;
  }
  return light;
}

Operations shade_and_count(const Choice& choice, Frame frame, const BandData& data, int pixel, int lights) {
  int type = 0;
  while (frame.light_begin[type + 1] == frame.light_begin[type]) ++type;
  frame.lists = 0;
  for (int t = 0; t <= LIGHT_COUNT; ++t) frame.light_begin[t] = t <= type ? 0 : lights;
  tape = {};
  shade_pixels(choice, data.planes->data(), &frame, data.lights.data(), data.lists.data(), data.tables.data(), data.out->data(), pixel);
  return needed();
}

}  // namespace

ShadingCost count_operations(const Choice& choice, const Frame& frame, const BandData& data) {
  if (data.lights.empty()) throw Error(ErrorKind::internal, "operations are counted with a light at least");
  const int pixel = surface_pixel(frame, *data.planes);
  const auto light_aside = [&](float aside) { return facing(data.lights.front(), frame, *data.planes, pixel, aside); };
  const std::vector<LightRecord> lights{light_aside(0.01f), light_aside(0.023f)};
  BandData pair = data;
  pair.lights = lights;
  const Operations one = shade_and_count(choice, frame, pair, pixel, 1), both = shade_and_count(choice, frame, pair, pixel, 2);
  const Operations light = difference(both, one);
  return {difference(one, light), light};
}

}  // namespace relume::bench
