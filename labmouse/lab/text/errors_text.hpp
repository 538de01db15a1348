// The scale of a contest's errors in words.
#pragma once

#include <string>

#include "labmouse/body/error_scale.hpp"

namespace labmouse {

/// "1 (contest)" or "1.1": the scale of the variation, with the name that it has.
std::string variation_text(double scale);

/// "noise 1 (as measured), variation 1 (contest)"
std::string text_of(const ErrorScale& errors);

/// What the numbers of both scales mean: "noise 1: as measured; variation 0: lab, 0.5: practice, 1: contest, ..."
std::string scales_text();

}  // namespace labmouse
