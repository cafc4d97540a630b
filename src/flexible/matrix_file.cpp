// SPDX-License-Identifier: Apache-2.0
#include "flexible/matrix_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "flexible/text_file.h"
#include "jprim/base/error.h"

namespace jprim {
namespace {

void checkInside(const TextFile& file, const char* what, int index, std::size_t rows) {
    if (index < 1 || index > int(rows))
        file.fail(fmt::format("{} {} is outside the matrix; the mesh has {} nodes with rows 1 to {}", what,
                              index, rows / 3, rows));
}

// The term on a line, with rows counted from 0.
MatrixTerm readTerm(const TextFile& file, std::size_t rows, const std::string& remedy) {
    std::string_view rest = file.getLine();
    MatrixTerm term;
    const bool isRead =
        takeNumber(rest, term.row) && takeNumber(rest, term.column) && takeNumber(rest, term.value);
    if (!isRead || !trim(rest).empty())
        file.fail(fmt::format("{} is not `row column value`; {}", quote(trim(file.getLine())), remedy));
    checkInside(file, "row", term.row, rows);
    checkInside(file, "column", term.column, rows);
    return {term.row - 1, term.column - 1, term.value};
}

void checkDiagonal(const std::string& path, const std::vector<bool>& hasDiagonal) {
    const auto missing = std::find(hasDiagonal.begin(), hasDiagonal.end(), false);
    if (missing == hasDiagonal.end()) return;
    const auto row = missing - hasDiagonal.begin() + 1;
    throw Error(path, fmt::format("there is no term in row {}, column {}; the file is cut short or belongs "
                                  "to another mesh",
                                  row, row));
}

void addMirrorImages(std::vector<MatrixTerm>& terms) {
    const std::size_t count = terms.size();
    terms.reserve(2 * count);
    for (std::size_t i = 0; i < count; ++i)
        if (terms[i].row != terms[i].column) terms.push_back({terms[i].column, terms[i].row, terms[i].value});
}

}  // namespace

std::vector<MatrixTerm> readMatrixFile(const std::string& path, const std::vector<int>& freedoms,
                                       const std::string& remedy) {
    TextFile file(path, remedy);
    std::vector<MatrixTerm> terms;
    std::vector<bool> hasDiagonal(freedoms.size());
    bool hasUpper = false, hasLower = false;
    while (file.nextLine()) {
        if (trim(file.getLine()).empty()) continue;
        const MatrixTerm term = readTerm(file, freedoms.size(), remedy);
        if (term.row == term.column) hasDiagonal[term.row] = true;
        hasUpper = hasUpper || term.row < term.column;
        hasLower = hasLower || term.row > term.column;
        // CalculiX writes the zeros between the directions of a mass matrix: two of three terms.
        if (term.value != 0) terms.push_back({freedoms[term.row], freedoms[term.column], term.value});
    }
    checkDiagonal(path, hasDiagonal);
    if (hasUpper != hasLower) addMirrorImages(terms);
    return terms;
}

}  // namespace jprim
