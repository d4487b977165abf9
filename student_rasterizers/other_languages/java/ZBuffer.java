import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * A z-buffer: v2 screen files on standard input, P6 pictures on standard output. Build with `javac -d classes ZBuffer.java`.
 * Samples: x to the right, y down; sample (x, y) has its center at (x + 0.5, y + 0.5). See docs/screen-files.md.
 */
public class ZBuffer {
    /** value = a x + b y + c, brought into low ... high. */
    record Plane(double a, double b, double c, double low, double high, String rule) {
        /** At the center of a sample. a x + b y + c is nearly the same; this has the same last bit as farop. */
        double at(int x, int y) {
            if (rule.equals("constant")) return c;
            if (!rule.equals("blocks")) {
                double value = a * (x + 0.5) + b * (y + 0.5) + c;
                return rule.equals("samples") ? (float) value : value;
            }
            int left = x & ~15, top = y & ~15; // of the block of 16 x 16 samples
            float start = (float) (a * (left + 0.5) + b * (top + 0.5) + c);
            float step = (float) a * (x - left) + (float) b * (y - top);
            return start + step;
        }

        double clamp(double value) {
            return value < low ? low : value > high ? high : value;
        }

        boolean isOverW() {
            return !rule.equals("constant") && !rule.equals("scanline");
        }
    }

    /** Corners in order around the outline; planes of depth, red, green, blue. */
    record Polygon(List<double[]> corners, List<Plane> planes) {}

    static Map<String, String[]> head;
    static List<Polygon> polygons;

    /** Reads the next file up to its `end`; false when there is none. */
    static boolean read(BufferedReader in) throws IOException {
        head = new HashMap<>();
        polygons = new ArrayList<>();
        for (String line; (line = in.readLine()) != null;) {
            String[] word = line.split("#", 2)[0].trim().split(" +");
            Polygon last = polygons.isEmpty() ? null : polygons.get(polygons.size() - 1);
            switch (word[0]) {
                case "polygon" -> polygons.add(new Polygon(new ArrayList<>(), new ArrayList<>()));
                case "plane" -> last.planes.add(new Plane(number(word[2]), number(word[3]), number(word[4]), number(word[5]),
                        number(word[6]), word[7]));
                case "vertex" -> last.corners.add(new double[] {number(word[1]), number(word[2])});
                case "end" -> { return true; }
                default -> head.put(word[0], word);
            }
        }
        return false;
    }

    static double number(String word) {
        return Double.parseDouble(word);
    }

    /** The first column whose center is at or right of an edge, on the center line of a row. */
    static int firstColumn(double[] upper, double[] lower, int row) {
        double dx = lower[0] - upper[0], dy = lower[1] - upper[1], down = row + 0.5 - upper[1];
        int column = (int) Math.ceil(upper[0] + down * dx / dy - 0.5);
        // The division was rounded; products of multiples of 1/256 are exact, so this is where it is decided.
        while ((column - 0.5 - upper[0]) * dy >= down * dx) column--;
        while ((column + 0.5 - upper[0]) * dy < down * dx) column++;
        return column;
    }

    /** Columns where edges cross the center line of a row. Inside is between first and second, third and fourth, ... */
    static List<Integer> crossings(Polygon polygon, int row) {
        List<Integer> columns = new ArrayList<>();
        int count = polygon.corners.size();
        for (int i = 0; i < count; i++) {
            double[] a = polygon.corners.get(i), b = polygon.corners.get((i + 1) % count);
            double[] upper = a[1] <= b[1] ? a : b, lower = a[1] <= b[1] ? b : a;
            // At or below the upper end, strictly above the lower one: the tie rule.
            if (upper[1] <= row + 0.5 && row + 0.5 < lower[1]) columns.add(firstColumn(upper, lower, row));
        }
        Collections.sort(columns);
        return columns;
    }

    /** Levels of red, green, blue, rows from the top. */
    static byte[] draw(int width, int height) {
        double[] depths = new double[width * height];
        byte[] levels = new byte[width * height * 3];
        for (int i = 0; i < levels.length; i++) levels[i] = level(number(head.get("background")[1 + i % 3]));
        boolean perspective = head.get("interpolation")[1].equals("perspective");
        for (Polygon polygon : polygons) {
            double top = polygon.corners.stream().mapToDouble(corner -> corner[1]).min().orElse(0);
            double bottom = polygon.corners.stream().mapToDouble(corner -> corner[1]).max().orElse(0);
            for (int y = (int) top; y < bottom; y++) {
                List<Integer> columns = crossings(polygon, y);
                for (int i = 0; i + 1 < columns.size(); i += 2)
                    for (int x = columns.get(i); x < columns.get(i + 1); x++) {
                        Plane plane = polygon.planes.get(0);
                        double depth = plane.clamp(plane.at(x, y));
                        int sample = y * width + x;
                        if (depth <= depths[sample]) continue; // of equal depths the first polygon stays
                        depths[sample] = depth;
                        for (int channel = 0; channel < 3; channel++)
                            levels[sample * 3 + channel] = level(value(polygon.planes.get(1 + channel), x, y, depth, perspective));
                    }
            }
        }
        return levels;
    }

    static double value(Plane plane, int x, int y, double depth, boolean perspective) {
        double value = plane.at(x, y);
        if (perspective && plane.isOverW()) value = plane.rule.equals("double") ? value / depth : (float) value / (float) depth;
        return plane.clamp(value);
    }

    static byte level(double light) {
        return (byte) Math.floor(Math.min(Math.max(255.0 * (float) light, 0), 255) + 0.5);
    }

    public static void main(String[] arguments) throws IOException {
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
        OutputStream out = System.out;
        while (read(in)) {
            int width = Integer.parseInt(head.get("size")[1]), height = Integer.parseInt(head.get("size")[2]);
            out.write(("P6\n" + width + " " + height + "\n255\n").getBytes("US-ASCII"));
            out.write(draw(width, height));
            out.flush();
        }
    }
}
