// A resident frame on a device as something to be measured: checked, counted, bound once and shaded again and again.
#pragma once

#include <memory>
#include <string>

#include "bench/operations.h"
#include "bench/resident_frame.h"
#include "bench/subject.h"

namespace relume::bench {

/// Of a pixel and a light of the frame.
ShadingCost cost_of(const ResidentFrame& frame);

/// `lit_pairs`: pixels times lights that shine on them; the arithmetic on others is of no use.
Work work_of(const ResidentFrame& frame, double lit_pairs);

/// Brute force, all pairs lit. Throws Error{device} where its image is not the twin's.
Subject resident_subject(const std::string& name, const std::shared_ptr<const ResidentFrame>& frame, const std::shared_ptr<Device>& device,
                         const Roof& roof);

/// What bounds a frame's pixels, which culling asks: worked out in each go, as for a frame that is seen once, or in the first, as for one that stays
/// while its lights change.
enum class Bounds { anew, held };

/// Lights culled anew in each go. `lit_pairs` as for work_of.
Subject culled_subject(const std::string& name, const std::shared_ptr<const ResidentFrame>& frame, const std::shared_ptr<Device>& device,
                       const Roof& roof, double lit_pairs, Bounds bounds);

/// Lights met through a light tree, cut anew in each go; the tree is made once.
Subject cut_subject(const std::string& name, const std::shared_ptr<const ResidentFrame>& frame, const std::shared_ptr<Device>& device,
                    const Roof& roof, double error);

}  // namespace relume::bench
