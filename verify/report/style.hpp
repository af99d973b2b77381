// The style sheet of the HTML report.
#pragma once

namespace requad::verify {

extern const char* const kReportStyle;

}  // namespace requad::verify
