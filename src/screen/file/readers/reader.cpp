// Reads a farop v2 screen file into vectors and says what is in it. c++ reader.cpp -o reader && ./reader FILE.scr
// Samples: x right, y down, centers at (i + 0.5, j + 0.5). See docs/screen-files.md.
#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>
struct Vertex { double x, y, inverse_w; std::vector<double> values; };  // red green blue, or normal and eye
struct Polygon { std::map<std::string, std::array<double, 3>> planes; std::vector<Vertex> vertices; };  // a b c by name

int main(int argc, char **argv) {
    std::ifstream file(argc > 1 ? argv[1] : "");
    if (!file) { std::puts("usage: reader FILE.scr"); return 1; }
    std::vector<Polygon> polygons;
    long width = 0, height = 0, vertices = 0;
    std::string line, keyword, skip, name;
    while (std::getline(file, line)) {
        std::istringstream words(line.substr(0, line.find('#')));
        if (!(words >> keyword)) continue;
        if (keyword == "size") words >> width >> height;
        if (keyword == "polygon") polygons.emplace_back();
        if (keyword == "plane" && words >> name)
            for (double &number : polygons.back().planes[name]) words >> number;
        if (keyword != "vertex") continue;
        Vertex vertex{};
        words >> vertex.x >> vertex.y >> vertex.inverse_w >> skip >> skip >> skip >> skip;  // xw yw w edge
        for (double value; words >> value;) vertex.values.push_back(value);
        polygons.back().vertices.push_back(vertex);
    }
    // Here begins your rasterizer: one color and one depth (1/w, larger is nearer) a sample.
    std::vector<double> xs, ys;
    for (auto &polygon : polygons) for (auto &v : polygon.vertices) xs.push_back(v.x), ys.push_back(v.y), vertices++;
    if (xs.empty()) xs.push_back(0), ys.push_back(0);
    auto x = std::minmax_element(xs.begin(), xs.end()), y = std::minmax_element(ys.begin(), ys.end());
    std::printf("size %ld %ld\npolygons %zu\nvertices %ld\n", width, height, polygons.size(), vertices);
    std::printf("x %.6f %.6f\ny %.6f %.6f\n", *x.first, *x.second, *y.first, *y.second);
}
