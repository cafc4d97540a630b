// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_REPORT_PAGE_H_
#define JPRIM_SRC_REPORT_PAGE_H_

#include <string_view>

namespace jprim {

/// The page without data, as web/ makes it; empty if it was not built.
std::string_view getReportPage();

}  // namespace jprim

#endif
