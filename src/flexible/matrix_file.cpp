// SPDX-License-Identifier: Apache-2.0
#include "flexible/matrix_file.h"

#include <algorithm>
#include <cstdint>

#include "base/format.h"
#include "base/text.h"
#include "flexible/text_file.h"
#include "jprim/base/error.h"

namespace jprim {
namespace {

// A term as a line gives it, rows and columns counted from 1; false if the line is none.
bool parseTerm(std::string_view line, MatrixTerm& term) {
    const bool isRead =
        takeNumber(line, term.row) && takeNumber(line, term.column) && takeNumber(line, term.value);
    return isRead && trim(line).empty();
}

class MatrixFileReader {
public:
    MatrixFileReader(const std::string& path, const std::vector<int>& freedoms, const std::string& remedy)
        : m_file(path, remedy), m_freedoms(freedoms), m_remedy(remedy), m_hasDiagonal(freedoms.size()) {}

    std::vector<MatrixTerm> read() {
        while (m_file.nextLine())
            if (!trim(m_file.getLine()).empty()) addTerm(readTerm());
        checkDiagonal();
        checkRepetitions();
        checkTriangles();
        if ((m_upper.count == 0) != (m_lower.count == 0)) addMirrorImages();
        return std::move(m_terms);
    }

private:
    /// The terms on one side of the diagonal that are not zero, and the first of them.
    struct Triangle {
        std::size_t count = 0;
        int row = 0, column = 0;
        std::string where;
    };

    void checkInside(const char* what, int index) const {
        const std::size_t rows = m_freedoms.size();
        if (index < 1 || index > int(rows))
            m_file.fail(fmt::format("{} {} is outside the matrix; the mesh has {} nodes with rows 1 to {}",
                                    what, index, rows / 3, rows));
    }

    MatrixTerm readTerm() const {
        MatrixTerm term;
        if (!parseTerm(m_file.getLine(), term))
            m_file.fail(
                fmt::format("{} is not `row column value`; {}", quote(trim(m_file.getLine())), m_remedy));
        checkInside("row", term.row);
        checkInside("column", term.column);
        return term;
    }

    void addTerm(const MatrixTerm& term) {
        m_places.push_back(std::uint64_t(term.row) << 32 | std::uint64_t(term.column));
        if (term.row == term.column) m_hasDiagonal[std::size_t(term.row) - 1] = true;
        // CalculiX writes the zeros between the directions of a mass matrix: two of three terms.
        if (term.value == 0) return;
        m_terms.push_back(
            {m_freedoms[std::size_t(term.row) - 1], m_freedoms[std::size_t(term.column) - 1], term.value});
        if (term.row == term.column) return;
        Triangle& triangle = term.row < term.column ? m_upper : m_lower;
        if (triangle.count++ == 0) triangle = {1, term.row, term.column, m_file.getWhere()};
    }

    void checkDiagonal() const {
        const auto missing = std::find(m_hasDiagonal.begin(), m_hasDiagonal.end(), false);
        if (missing == m_hasDiagonal.end()) return;
        const auto row = missing - m_hasDiagonal.begin() + 1;
        throw Error(m_file.getPath(), fmt::format("there is no term in row {}, column {}; the file is cut "
                                                  "short or belongs to another mesh",
                                                  row, row));
    }

    void checkRepetitions() {
        std::sort(m_places.begin(), m_places.end());
        const auto repeated = std::adjacent_find(m_places.begin(), m_places.end());
        if (repeated == m_places.end()) return;
        const int row = int(*repeated >> 32), column = int(*repeated & 0xffffffffu);
        const std::vector<int> lines = findLinesOfTerm(m_file.getPath(), row, column);
        throw Error(fmt::format("{}:{}", m_file.getPath(), lines.at(1)),
                    fmt::format("row {}, column {} stands here a second time, after line {}; take one out",
                                row, column, lines[0]));
    }

    // In a file of one triangle a stray term of the other would make it look full.
    void checkTriangles() const {
        const bool isUpper = m_upper.count > m_lower.count;
        const Triangle &most = isUpper ? m_upper : m_lower, &stray = isUpper ? m_lower : m_upper;
        if (stray.count == 0 || 2 * stray.count > most.count) return;
        throw Error(
            stray.where,
            fmt::format("row {}, column {} is {} the diagonal, where only {} of {} terms are; the file "
                        "must hold one triangle or both in full",
                        stray.row, stray.column, isUpper ? "below" : "above", stray.count,
                        stray.count + most.count));
    }

    void addMirrorImages() {
        const std::size_t count = m_terms.size();
        m_terms.reserve(2 * count);
        for (std::size_t i = 0; i < count; ++i) {
            const MatrixTerm& term = m_terms[i];
            if (term.row != term.column) m_terms.push_back({term.column, term.row, term.value});
        }
    }

    TextFile m_file;
    const std::vector<int>& m_freedoms;
    const std::string& m_remedy;
    std::vector<bool> m_hasDiagonal;
    std::vector<std::uint64_t> m_places;
    std::vector<MatrixTerm> m_terms;
    Triangle m_upper, m_lower;
};

}  // namespace

std::vector<MatrixTerm> readMatrixFile(const std::string& path, const std::vector<int>& freedoms,
                                       const std::string& remedy) {
    return MatrixFileReader(path, freedoms, remedy).read();
}

std::vector<int> findLinesOfTerm(const std::string& path, int row, int column) {
    std::vector<int> lines;
    TextFile file(path, "");
    for (int line = 1; file.nextLine(); ++line) {
        MatrixTerm term;
        if (parseTerm(file.getLine(), term) && term.row == row && term.column == column)
            lines.push_back(line);
    }
    return lines;
}

}  // namespace jprim
