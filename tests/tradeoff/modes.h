#pragma once

#include <string>
#include <vector>

namespace tradeoff {

/// Refuses options that would be ignored. `given` are the names of the options on the command line. Throws
/// std::runtime_error that names the first option that what is asked for does not take, and those that it takes.
void check_options(const std::vector<std::string>& given);

}  // namespace tradeoff
