// Reads a farop v2 screen file into lists and says what is in it. javac Reader.java && java Reader FILE.scr
// Samples: x right, y down, centers at (i + 0.5, j + 0.5). See docs/screen-files.md.
import java.nio.file.*;
import java.util.*;
import java.util.stream.*;

public class Reader {
    record Vertex(double x, double y, double inverseW, double[] values) {} // red green blue, or normal and eye
    record Polygon(int surface, Map<String, double[]> planes, List<Vertex> vertices) {} // planes: a b c low high

    static double[] numbers(String[] word, int from, int to) {
        return Arrays.stream(word, from, to).mapToDouble(Double::parseDouble).toArray();
    }

    public static void main(String[] arguments) throws Exception {
        int width = 0, height = 0;
        List<Polygon> polygons = new ArrayList<>();
        for (String line : Files.readAllLines(Path.of(arguments[0]))) {
            String[] word = line.replaceAll("#.*", "").trim().split("\\s+");
            Polygon last = polygons.isEmpty() ? null : polygons.get(polygons.size() - 1);
            switch (word[0]) {
                case "size" -> { width = Integer.parseInt(word[1]); height = Integer.parseInt(word[2]); }
                case "polygon" ->
                    polygons.add(new Polygon(Integer.parseInt(word[3]), new HashMap<>(), new ArrayList<>()));
                case "plane" -> last.planes().put(word[1], numbers(word, 2, 7));
                case "vertex" -> { // x y inverse_w xw yw w edge, then values
                    double[] at = numbers(word, 1, 4);
                    last.vertices().add(new Vertex(at[0], at[1], at[2], numbers(word, 8, word.length)));
                }
                default -> { }
            }
        }
        // Here begins your rasterizer: one color and one depth (1/w, larger is nearer) a sample.
        List<Vertex> all = polygons.stream().flatMap(polygon -> polygon.vertices().stream()).toList();
        DoubleSummaryStatistics x = all.stream().collect(Collectors.summarizingDouble(Vertex::x));
        DoubleSummaryStatistics y = all.stream().collect(Collectors.summarizingDouble(Vertex::y));
        System.out.printf("size %d %d%npolygons %d%nvertices %d%n", width, height, polygons.size(), all.size());
        System.out.printf(Locale.ROOT, "x %.6f %.6f%ny %.6f %.6f%n", x.getMin(), x.getMax(), y.getMin(), y.getMax());
    }
}
