// SPDX-License-Identifier: Apache-2.0
#include "jprim/dataset/source_text.h"

#include <algorithm>

namespace jprim {

SourcePosition SourceText::getPosition(std::size_t offset) const {
    const auto after = std::upper_bound(segments.begin(), segments.end(), offset,
                                        [](std::size_t o, const Segment& s) { return o < s.begin; });
    if (after == segments.begin()) return {};
    const Segment& segment = *(after - 1);
    return {segment.where.line, segment.where.column + static_cast<int>(offset - segment.begin)};
}

}  // namespace jprim
