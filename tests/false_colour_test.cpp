// False colours of values that leave their formulas nothing to divide by.
#include "gbuffer/false_colour.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/made_up_exr.h"

namespace relume {
namespace {

TEST(FalseColour, ANumberTooLargeToHaveARange) {
  const MadeUpExr made({{"", "", {"roughness"}}}, 4, 4, [](const std::string&, int, int) { return 1e20; });
  Reading reading;
  reading.roles["roughness"] = {0, "roughness", {"roughness"}, {SampleType::float32}};
  reading.data_window = reading.display_window = {0, 0, 4, 4};
  const std::vector<View> views = false_colour_views(ExrFile(made.file), reading);
  ASSERT_EQ(views.size(), 1u);
  const std::vector<unsigned char> darkest{68, 1, 84};
  EXPECT_TRUE(std::equal(darkest.begin(), darkest.end(), views[0].picture.codes.begin())) << int(views[0].picture.codes[0]);
}

}  // namespace
}  // namespace relume
