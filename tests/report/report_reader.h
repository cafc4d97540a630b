// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_REPORT_REPORT_READER_H_
#define JPRIM_TESTS_REPORT_REPORT_READER_H_

#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace jprim::testing {

/// A report as a browser finds it: what stands between the tags, and no more.
class ReportReader {
public:
    explicit ReportReader(const std::string& path) {
        std::ostringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        m_html = text.str();
        json = nlohmann::json::parse(findBlock("application/json", "jprim-report"));
    }

    size_t getSize() const { return m_html.size(); }

    /// The numbers of an array, whatever their type.
    std::vector<double> read(const nlohmann::json& array) const {
        const std::string bytes =
            decode(findBlock("application/octet-stream;base64", "jprim-data-" + array["block"].dump()));
        size_t count = 1;
        for (const auto& n : array["shape"]) count *= n.get<size_t>();
        const bool isDouble = array["type"] == "f64";
        if (bytes.size() != count * (isDouble ? 8 : 4))
            throw std::runtime_error("a block is not of its shape");
        std::vector<double> numbers(count);
        for (size_t k = 0; k < count; ++k) {
            float single = 0;
            if (isDouble) {
                std::memcpy(&numbers[k], bytes.data() + 8 * k, 8);
            } else {
                std::memcpy(&single, bytes.data() + 4 * k, 4);
                numbers[k] = single;
            }
        }
        return numbers;
    }

    /// A table by its name; null if there is none.
    nlohmann::json findTable(const std::string& name) const {
        for (const auto& table : json["tables"])
            if (table["name"] == name) return table;
        return nullptr;
    }

    nlohmann::json json;

private:
    std::string findBlock(const std::string& type, const std::string& id) const {
        const std::string tag = "<script type=\"" + type + "\" id=\"" + id + "\">";
        const size_t begin = m_html.find(tag);
        if (begin == m_html.npos || m_html.find(tag, begin + 1) != m_html.npos)
            throw std::runtime_error(id + " is not there once");
        const size_t end = m_html.find("</script", begin);
        return m_html.substr(begin + tag.size(), end - begin - tag.size());
    }

    static std::string decode(const std::string& text) {
        static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string bytes;
        unsigned bits = 0, count = 0;
        for (const char c : text) {
            if (c == '=') break;
            bits = bits << 6 | unsigned(digits.find(c));
            count += 6;
            if (count < 8) continue;
            count -= 8;
            bytes += char(bits >> count & 255);
        }
        return bytes;
    }

    std::string m_html;
};

}  // namespace jprim::testing

#endif
