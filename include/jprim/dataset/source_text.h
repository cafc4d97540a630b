// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_DATASET_SOURCE_TEXT_H_
#define JPRIM_DATASET_SOURCE_TEXT_H_

#include <cstddef>
#include <string>
#include <vector>

#include "jprim/base/diagnostic.h"

namespace jprim {

/// A text taken from a file, whose every character knows where it stood there. Comments and line breaks are
/// taken out, so one text may come from several lines.
struct SourceText {
    std::string text;

    /// The position in the file of the character at this offset of `text`; text.size() gives the place just
    /// after the last one. No position if the text came from no file.
    SourcePosition getPosition(std::size_t offset) const;

    /// A stretch of `text`, from `begin` to the next segment, that stood in one line without a gap.
    struct Segment {
        std::size_t begin = 0;
        SourcePosition where;  ///< of its first character
    };
    std::vector<Segment> segments;  ///< in the order of the text; empty if it came from no file
};

/// Two texts are equal if they say the same, wherever they stood.
inline bool operator==(const SourceText& a, const SourceText& b) {
    return a.text == b.text;
}
inline bool operator!=(const SourceText& a, const SourceText& b) {
    return !(a == b);
}

/// A function expression of a dataset, not parsed: `DX(1,2) + 3*SIN(TIME)`. Its blanks are single spaces.
/// A mistake at an offset of the text is reported at getPosition(offset).
using ExpressionText = SourceText;

}  // namespace jprim

#endif
