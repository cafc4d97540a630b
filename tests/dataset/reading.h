// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_DATASET_READING_H_
#define JPRIM_TESTS_DATASET_READING_H_

#include <gtest/gtest.h>

#include <string>

#include "dataset/reader_properties.h"

namespace jprim {

/// What came of a text. Whatever a test is about, the reader's general properties are checked too.
struct Reading {
    Dataset dataset;
    std::string findings;  ///< one `line:column: severity: message` per line, empty if there are none
};

inline Reading read(const std::string& text) {
    EXPECT_EQ(findBrokenProperty(text), "") << text;
    Diagnostics diagnostics;
    Reading reading;
    reading.dataset = readDataset(text, diagnostics);
    for (const Diagnostic& d : diagnostics)
        reading.findings += (reading.findings.empty() ? "" : "\n") + formatDiagnostic("", d).substr(1);
    return reading;
}

/// Reads statements that follow two parts with one marker each. The first of them stands in line 3.
inline Reading readInModel(const std::string& statements) {
    return read("title\nPART/1, GROUND; MARKER/1; PART/2; MARKER/2\n" + statements + "\nEND\n");
}

/// The same for statements that must be understood without a word.
inline Dataset readGood(const std::string& statements) {
    const Reading reading = readInModel(statements);
    EXPECT_EQ(reading.findings, "") << statements;
    return reading.dataset;
}

}  // namespace jprim

#endif
