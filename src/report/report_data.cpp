// SPDX-License-Identifier: Apache-2.0
#include "report/report_data.h"

#include <fstream>

#include "base/text.h"
#include "jprim/base/error.h"
#include "report/page.h"

namespace jprim {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "pages read little-endian numbers");

namespace {

constexpr std::string_view Placeholder = "<!--JPRIM-DATA-->";

std::string encodeBase64(const std::vector<unsigned char>& bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        const std::size_t left = bytes.size() - k;
        const unsigned group = unsigned(bytes[k]) << 16 | (left > 1 ? unsigned(bytes[k + 1]) << 8 : 0) |
                               (left > 2 ? unsigned(bytes[k + 2]) : 0);
        text += digits[group >> 18];
        text += digits[group >> 12 & 63];
        text += left > 1 ? digits[group >> 6 & 63] : '=';
        text += left > 2 ? digits[group & 63] : '=';
    }
    return text;
}

// Without `<` no text can end the element that it stands in. In JSON that character is in texts only.
std::string encodeJson(const Json& json) {
    std::string text;
    for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    return text;
}

}  // namespace

void ReportData::writeBlocks(std::ostream& stream) const {
    stream << "<script type=\"application/json\" id=\"jprim-report\">" << encodeJson(json) << "</script>\n";
    for (std::size_t k = 0; k < m_blocks.size(); ++k)
        stream << "<script type=\"application/octet-stream;base64\" id=\"jprim-data-" << k << "\">"
               << encodeBase64(m_blocks[k]) << "</script>\n";
}

void ReportData::write(const std::string& path) const {
    const std::string_view page = getReportPage();
    const std::size_t at = page.find(Placeholder);
    if (at == page.npos)
        throw Error(path,
                    "there is no page to put the report into: jprim was built without node and npm (Debian: "
                    "nodejs, npm)");
    std::ofstream stream(path, std::ios::binary);
    stream << page.substr(0, at);
    writeBlocks(stream);
    stream << page.substr(at + Placeholder.size());
    stream.close();
    if (!stream) throw Error(path, "cannot be written");
}

}  // namespace jprim
