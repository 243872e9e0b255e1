// Samples: the same rows as sample_rows, each layer decoded once, and anew where the reading takes it from elsewhere.
#include "gbuffer/samples.h"

#include <gtest/gtest.h>

#include "gbuffer/watched.h"
#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {
namespace {

/// A frame that is sampled in several bands, each of blocks too large for the header's buffer.
struct Frame {
  Frame() {
    MadeUpGBuffer made = MadeUpGBuffer::of_size(1920, 200);
    made.with({"A", "depth.Z", "albedo.R", "albedo.G", "albedo.B"});
    write_gbuffer(folder / "g.exr", made);
    reading.data_window = made.data;
    reading.roles["position"] = vector("P", "XYZ");
    reading.roles["normal"] = vector("N", "XYZ");
  }
  static RoleLayer vector(const std::string& layer, const std::string& components) {
    RoleLayer role{0, layer, {}, {}};
    for (const char c : components) {
      role.channels.push_back(layer + '.' + c);
      role.types.push_back(SampleType::float32);
    }
    return role;
  }
  void expect_as_sampled(const std::vector<SampledBand>& bands, const std::vector<std::string>& roles) const {
    const ExrFile again(folder / "g.exr");
    const std::vector<SampledBand> expected = sample_rows(again, reading, roles);
    ASSERT_EQ(bands.size(), expected.size());
    for (std::size_t i = 0; i < bands.size(); ++i) {
      EXPECT_EQ(bands[i].window, expected[i].window);
      EXPECT_EQ(bands[i].planes, expected[i].planes) << "band " << i;
    }
  }

  const TemporaryFolder folder;
  Reading reading;
};

/// Blocks that are read from the disk meanwhile.
template <class Work>
std::uint64_t blocks_read(const Work& work) {
  const std::uint64_t before = watched().beats;
  work();
  return watched().beats - before;
}

TEST(Samples, AreThoseOfSampleRows) {
  const Frame frame;
  const ExrFile file(frame.folder / "g.exr");
  Samples samples(file);
  frame.expect_as_sampled(samples.bands(frame.reading), {"position", "normal"});
}

TEST(Samples, AskedAgainReadNothing) {
  const Frame frame;
  const ExrFile file(frame.folder / "g.exr");
  Samples samples(file);
  EXPECT_GT(blocks_read([&] { samples.bands(frame.reading); }), 0u);
  EXPECT_EQ(blocks_read([&] { samples.bands(frame.reading); }), 0u) << "decoded a second time";
}

TEST(Samples, MoreRolesJoinThoseHeld) {
  Frame frame;
  const ExrFile file(frame.folder / "g.exr");
  Samples samples(file);
  samples.bands(frame.reading);
  frame.reading.roles["coverage"] = {0, "A", {"A"}, {SampleType::float32}};
  frame.expect_as_sampled(samples.bands(frame.reading), {"position", "normal", "coverage"});
  frame.reading.roles["albedo"] = Frame::vector("albedo", "RGB");
  frame.expect_as_sampled(samples.bands(frame.reading), {"position", "normal", "coverage"});
  frame.expect_as_sampled(samples.bands(frame.reading, {"albedo"}), {"position", "normal", "coverage", "albedo"});
}

TEST(Samples, FollowTheReading) {
  Frame frame;
  const ExrFile file(frame.folder / "g.exr");
  Samples samples(file);
  samples.bands(frame.reading);
  std::swap(frame.reading.roles["position"], frame.reading.roles["normal"]);
  frame.expect_as_sampled(samples.bands(frame.reading), {"position", "normal"});
  frame.reading.roles.erase("normal");
  frame.expect_as_sampled(samples.bands(frame.reading), {"position"});
  frame.reading.data_window = {100, 10, 500, 90};
  frame.expect_as_sampled(samples.bands(frame.reading), {"position"});
}

}  // namespace
}  // namespace relume
