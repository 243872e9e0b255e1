// The light of a band's pixels: every program under every group of lights, then each light alone where its layer is wanted.
#pragma once

#include <functional>
#include <vector>

#include "gbuffer/gbuffer.h"
#include "host/binding.h"
#include "host/device.h"
#include "host/environment_shading.h"
#include "host/light_links.h"
#include "host/light_lists.h"
#include "host/output_layout.h"
#include "host/stopwatch.h"

namespace relume {

class BandShading {
 public:
  /// All of them outlive it. `error`: share of itself that a pixel's radiance may be off by, through a light tree; 0: exact.
  BandShading(Device& device, const Binding& binding, const LightLinks& lights, const OutputLayout& layout, const Reading& reading, double error,
              const EnvironmentOptions& environments = {});

  /// Planes of `out` that shade() needs: the layout's own, behind them the colours of each linked group of lights, and the error.
  int planes() const { return layout_.planes() + linked_planes() + (environments_.estimates() ? 1 : 0); }
  /// The plane of the squared error that samples of environments leave; -1: none do.
  int error_plane() const { return environments_.estimates() ? planes() - 1 : -1; }
  /// Planes that a band needs for its caller's shading.
  int spare_planes() const { return binding_.spare_planes() + environments_.spare_planes(); }

  /// Adds a band's irradiance, pixel by pixel, to what a mean is made of: every surface is shaded as Lambert with albedo pi.
  struct Irradiance {
    glm::dvec3 sum{0};
    double surface_pixels = 0;
    glm::dvec3 mean() const { return surface_pixels > 0 ? sum / surface_pixels : sum; }
  };
  void add_irradiance(GBuffer& gbuffer, Irradiance& irradiance, const Progress& progress) const;

  /// Each group's ambient radiance, W/(m^2 sr), where ambient lights may be shares of the frame's mean direct irradiance. Before shade().
  void set_ambient(const glm::dvec3& mean_irradiance);

  /// Shades a band into planes() planes of `out`; laps "bind", "shade" and "link". `progress` counts pixels times rounds().
  void shade(GBuffer& gbuffer, Planes& out, Stopwatch& watch, const Progress& progress) const;
  /// What light trees made of the bands so far: the bound, and how many lights are met.
  std::string tree_sentence() const;
  /// How often each pixel is shaded for the total.
  double rounds() const { return double(binding_.programs().size() * (lights_.groups().size() + lights_.environments().size())); }

 private:
  struct TreeStatistics {
    int lights = 0;                               ///< that trees take care of
    std::int64_t pixels = 0, met = 0, exact = 0;  ///< shaded; lights and stand-ins that they met; pixels whose cuts did not fit
  };

  int linked_planes() const { return int(lights_.groups().size() - 1) * layout_.colours() * 3; }
  Frame frame_of(const GBuffer& gbuffer, const Planes& out) const;
  std::vector<int> list_lights(const GBuffer& gbuffer, const Frame& frame, std::span<const Choice> programs, LightLists& lists) const;
  void aim(Frame& frame, std::size_t group) const;
  void shade_programs(Band& band, Frame& frame, const Progress& progress) const;
  void shade_lights(Band& band, Frame frame, const Progress& progress) const;
  void add_environment(Band& band, Frame frame, const RigLight& light, const Progress& progress) const;
  void add_linked(const GBuffer& gbuffer, Planes& out, const Frame& bound) const;

  Device& device_;
  const Binding& binding_;
  const LightLinks& lights_;
  const OutputLayout& layout_;
  const Reading& reading_;
  const double error_;
  EnvironmentShading environments_;
  std::vector<glm::dvec3> ambient_;   ///< of each group
  std::vector<LightTree> trees_;      ///< of each group
  std::vector<LightRecord> records_;  ///< the lights', and behind them what stands in for clusters of them
  std::vector<SortedLights> sorted_;  ///< of each group
  mutable TreeStatistics statistics_;
};

}  // namespace relume
