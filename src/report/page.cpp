// SPDX-License-Identifier: Apache-2.0
// The assembler reads the page's file: as an array of numbers it would take the compiler long.
#include "report/page.h"

#ifdef JPRIM_REPORT_PAGE
asm(".pushsection .rodata\n"
    ".global jprim_report_page, jprim_report_page_end\n"
    "jprim_report_page:\n"
    ".incbin \"" JPRIM_REPORT_PAGE
    "\"\n"
    "jprim_report_page_end:\n"
    ".byte 0\n"
    ".popsection\n");

extern "C" const char jprim_report_page[], jprim_report_page_end[];
#endif

namespace jprim {

std::string_view getReportPage() {
#ifdef JPRIM_REPORT_PAGE
    return {jprim_report_page, static_cast<std::size_t>(jprim_report_page_end - jprim_report_page)};
#else
    return {};
#endif
}

}  // namespace jprim
