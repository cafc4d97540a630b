// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_REPORT_REPORT_DATA_H_
#define JPRIM_SRC_REPORT_REPORT_DATA_H_

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace jprim {

using Json = nlohmann::ordered_json;

/// What a page is given: a tree of values and, for its many numbers, blocks of bytes that the tree refers to.
class ReportData {
public:
    Json json;

    /// Keeps numbers, row after row, and gives what stands for them in the tree.
    template <class T>
    Json addArray(const std::vector<T>& numbers, const std::vector<std::size_t>& shape) {
        static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>);
        const auto* const bytes = reinterpret_cast<const unsigned char*>(numbers.data());
        m_blocks.emplace_back(bytes, bytes + numbers.size() * sizeof(T));
        const char* const type = std::is_same_v<T, float> ? "f32" : "f64";
        return {{"block", m_blocks.size() - 1}, {"type", type}, {"shape", shape}};
    }

    size_t getNumBytes() const {
        size_t sum = 0;
        for (const std::vector<unsigned char>& block : m_blocks) sum += block.size();
        return sum;
    }

    /// Writes the page with everything in it. @throws Error if there is no page or the file cannot be written
    void write(const std::string& path) const;

private:
    void writeBlocks(std::ostream& stream) const;

    std::vector<std::vector<unsigned char>> m_blocks;
};

}  // namespace jprim

#endif
