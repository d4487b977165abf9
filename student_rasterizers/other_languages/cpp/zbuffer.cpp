// A z-buffer as a library in C++, span by span.
// g++ -O2 -std=c++17 -ffp-contract=off -shared -fPIC -I../c -o zbuffer.so zbuffer.cpp
#include "../c/farop.h"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace {

// The first column whose center is at or right of the edge a -> b (downward) on the center line of a row.
int first_column(const farop_vertex &a, const farop_vertex &b, int row) {
    const double dx = b.x - a.x, dy = b.y - a.y, down = row + 0.5 - a.y;
    int column = static_cast<int>(std::ceil(a.x + down * dx / dy - 0.5));
    // The division was rounded; products of multiples of 1/256 are exact, so this is where it is decided.
    while ((column - 0.5 - a.x) * dy >= down * dx) column--;
    while ((column + 0.5 - a.x) * dy < down * dx) column++;
    return column;
}

// For every row of the picture: the columns where edges cross its center line.
std::vector<std::vector<int>> crossings(const farop_list &list, const farop_polygon &polygon) {
    std::vector<std::vector<int>> rows(list.height);
    for (std::uint32_t i = 0; i < polygon.vertex_count; i++) {
        const farop_vertex *a = &list.vertices[polygon.first_vertex + i];
        const farop_vertex *b = &list.vertices[polygon.first_vertex + (i + 1) % polygon.vertex_count];
        if (a->y > b->y) std::swap(a, b);
        // Centers at or below the upper end, strictly above the lower one: the tie rule. Level edges cross nothing.
        const int end = static_cast<int>(std::ceil(b->y - 0.5));
        for (int row = static_cast<int>(std::ceil(a->y - 0.5)); row < end; row++) rows[row].push_back(first_column(*a, *b, row));
    }
    for (auto &columns : rows) std::sort(columns.begin(), columns.end());
    return rows;
}

void draw_sample(const farop_list &list, const farop_polygon &polygon, int x, int y, farop_target &target) {
    const double depth = farop_depth(&list, &polygon, x, y);
    const std::size_t sample = static_cast<std::size_t>(y) * target.width + x;
    if (depth <= target.depth[sample]) return; // of equal depths the first polygon stays
    target.depth[sample] = depth;
    for (std::uint32_t channel = 0; channel < 3; channel++)
        target.rgb[sample * 3 + channel] = static_cast<float>(farop_value(&list, &polygon, channel, x, y, depth));
}

} // namespace

void farop_draw(const farop_list *list, farop_target *target) {
    if (list->abi != FAROP_ABI || list->varying != FAROP_COLOR) return; // flat and Gouraud lists
    for (std::uint32_t p = 0; p < list->polygon_count; p++) {
        const farop_polygon &polygon = list->polygons[p];
        const auto rows = crossings(*list, polygon);
        for (int y = 0; y < static_cast<int>(rows.size()); y++)
            for (std::size_t i = 0; i + 1 < rows[y].size(); i += 2)
                for (int x = rows[y][i]; x < rows[y][i + 1]; x++) draw_sample(*list, polygon, x, y, *target);
    }
}
