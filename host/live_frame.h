// A frame that stays on a device and follows its lights: where one light changes, only the pixels that it reached or reaches are shaded, under that
// light alone. For what keeps G-buffers open: a service, a viewer.
//
// How it stays exact: one light is held apart. The sums of all the others, as they are before the held light is added, lie beside the picture, and a
// change adds the held light to them anew; nothing is ever subtracted, so nothing drifts. The picture depends on the lights and on which one is held,
// not on what they were before: its bits are those of shading the others as ever (host/light_records.h) and the held one last. To hold another light
// costs one shading of the frame.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gbuffer/gbuffer.h"
#include "host/binding.h"
#include "host/device.h"
#include "host/frame_bounds.h"
#include "host/light_lists.h"
#include "host/light_records.h"

namespace relume {

class LiveFrame {
 public:
  /// All pixels of a frame (gbuffer/gbuffer.h) and what their materials are (host/binding.h). `device`, `binding` and `reading` outlive it. Bits of
  /// the device's memory: the G-buffer's planes and 12 more.
  LiveFrame(Device& device, GBuffer gbuffer, const Binding& binding, const Reading& reading);
  LiveFrame(const LiveFrame&) = delete;
  LiveFrame& operator=(const LiveFrame&) = delete;

  /// Other lights altogether. Error{input} for lights that are linked to objects, and for ambient fractions: these need more than pixels know.
  void set_lights(std::vector<Light> lights);

  /// The light of this number (in the order of set_lights) as it is now. Its type may change. Holds it, where it was not held.
  void change_light(std::size_t number, const Light& light);

  /// Planes R G B, W/(m^2 sr), of all pixels; 0 where no surface is shown.
  const Planes& radiance() const { return out_; }
  const Window& window() const { return gbuffer_.window; }

  /// Share of the blocks of pixels that the last change shaded.
  double touched() const { return touched_; }

 private:
  static constexpr int total = 0, ambient = 3, sums = 6, planes = 12;

  void check(const Light& light) const;
  void hold(std::size_t number);
  /// Each light where it reaches.
  void shade_all(const LightRecords& lights, int sums_out);
  /// Shades the lights for all pixels, or for those that meet them by `lists`, where Frame::lists is 1.
  void shade(const LightRecords& lights, std::span<const int> lists, int sums_out, int base);
  std::vector<int> lists_of(const LightRecords& before, const LightRecords& now);

  Device& device_;
  const Binding& binding_;
  GBuffer gbuffer_;
  Planes out_;
  Frame frame_;
  std::optional<FrameBounds> bounds_;  ///< of gbuffer_ and frame_
  LightLists lists_;                   ///< their memory is used again
  std::vector<Light> lights_;
  std::optional<std::size_t> held_;
  double touched_ = 0;
};

}  // namespace relume
