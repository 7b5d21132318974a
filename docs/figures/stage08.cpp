#include "docs/figures/figures.hpp"
namespace rt::figures {
std::string cone_roots() {
    return {};
}
std::string cone_slope() {
    return {};
}
std::string cone_erratum() {
    return {};
}
}  // namespace rt::figures
