// A table of BRDF values from the kernels that shade frames.
#pragma once

#include <string>
#include <vector>

namespace relume {

/// `brdf`: a lobe's name; of both halves where both have it. `table`: CSV with a header; columns n_l, n_v, l_v in double, and parameters by name
/// (with .r .g .b for one channel of three); other columns are kept. Returns it with f_r (1/sr) and reflectance (f_r n.l) appended, 9 digits. Throws
/// Error{input} that names the line and column.
std::string evaluate_table(const std::string& brdf, const std::vector<std::string>& set, const std::string& device, const std::string& table);

}  // namespace relume
