//! Transparent fragments of a picture, kept apart until everything is drawn.
//!
//! Why kept: blending is exact only front to back, and the front is known only at the end. So drawing order does not
//! matter, and rasterizers need not know about transparency.
//!
//! Cost: 48 bytes a transparent fragment; none where the plan says that everything is opaque.

use crate::color::Rgb;
use crate::plan::Transparency;
use crate::screen::Fragment;

/// The layers of all samples of a target: one linked list a sample, in one arena.
#[derive(Clone, Debug, Default)]
pub(super) struct Layers {
    /// Per sample: 1 + index of its newest layer, 0 for none. Empty until the first transparent fragment.
    heads: Vec<u32>,
    arena: Vec<Layer>,
}

#[derive(Clone, Copy, Debug)]
struct Layer {
    fragment: Fragment,
    /// As `heads`.
    next: u32,
}

impl Layers {
    /// Keeps `fragment` for the sample at `index` of `samples`.
    pub(super) fn push(&mut self, index: usize, samples: usize, fragment: Fragment) {
        self.heads.resize(samples, 0);
        self.arena.push(Layer { fragment, next: self.heads[index] });
        self.heads[index] = self.arena.len() as u32;
    }

    /// Forgets everything and keeps the memory.
    pub(super) fn clear(&mut self) {
        self.heads.clear();
        self.arena.clear();
    }

    /// Whether nothing transparent was drawn.
    pub(super) fn is_empty(&self) -> bool {
        self.arena.is_empty()
    }

    /// Collects the layers of one sample that lie in front of its opaque `depth`, nearest first, ties in list order.
    pub(super) fn in_front(&self, index: usize, depth: f64, owner: u32, sorted: &mut Vec<Fragment>) {
        sorted.clear();
        let mut link = self.heads.get(index).copied().unwrap_or(0);
        while link != 0 {
            let layer = self.arena[link as usize - 1];
            let nearer = layer.fragment.depth > depth;
            // At equal depth the polygon that comes first in the list is in front.
            if nearer || (layer.fragment.depth == depth && layer.fragment.polygon < owner) {
                sorted.push(layer.fragment);
            }
            link = layer.next;
        }
        sorted.sort_by(|a, b| b.depth.total_cmp(&a.depth).then(a.polygon.cmp(&b.polygon)));
    }
}

/// What `layers` (front to back) and the opaque color behind them show together.
pub(super) fn composite(layers: &[Fragment], behind: Rgb<f32>, rule: Transparency) -> Rgb<f32> {
    let mut light = Rgb::BLACK;
    // Over: the share of light that gets through so far. Additive: what is left of 1.
    let mut through = Rgb::WHITE;
    for layer in layers {
        let opacity = layer.opacity.to_f64();
        let share = match rule {
            Transparency::Over => opacity * through,
            Transparency::Additive => minimum(opacity, through),
        };
        light += layer.color.to_f64() * share;
        through = through - share;
    }
    (light + behind.to_f64() * through).to_f32()
}

fn minimum(a: Rgb, b: Rgb) -> Rgb {
    Rgb::new(a.r.min(b.r), a.g.min(b.g), a.b.min(b.b))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layer(depth: f64, polygon: u32, light: f32, opacity: f32) -> Fragment {
        Fragment { x: 0, y: 0, depth, color: Rgb::gray(light), opacity: Rgb::gray(opacity), polygon }
    }

    #[test]
    fn a_thousand_layers_give_the_exact_product() {
        let layers: Vec<_> = (0..1000).map(|index| layer(1.0, index, 0.0, 0.001)).collect();
        let shown = composite(&layers, Rgb::gray(1.0), Transparency::Over);
        let exact = (1.0 - f64::from(0.001_f32)).powi(1000);
        assert!((f64::from(shown.r) - exact).abs() < 1e-6, "{} {exact}", shown.r);
    }

    #[test]
    fn nothing_is_kept_until_something_is_transparent() {
        let mut layers = Layers::default();
        assert_eq!((layers.heads.capacity(), layers.arena.capacity()), (0, 0));
        layers.push(2, 5, layer(1.0, 0, 1.0, 0.5));
        assert_eq!((layers.heads.len(), layers.arena.len()), (5, 1));
    }

    #[test]
    fn drawing_order_does_not_matter() {
        let (near, far) = (layer(2.0, 0, 1.0, 0.5), layer(1.0, 1, 0.5, 0.5));
        let mut pictures = Vec::new();
        for order in [[near, far], [far, near]] {
            let (mut layers, mut sorted) = (Layers::default(), Vec::new());
            order.iter().for_each(|&fragment| layers.push(0, 1, fragment));
            layers.in_front(0, 0.0, u32::MAX, &mut sorted);
            pictures.push(composite(&sorted, Rgb::gray(0.0), Transparency::Over));
        }
        assert_eq!(pictures[0], pictures[1]);
        assert_eq!(pictures[0].r, 0.5 + 0.25 * 0.5);
    }

    #[test]
    fn additive_stops_at_one() {
        let layers = [layer(3.0, 0, 1.0, 0.75), layer(2.0, 1, 1.0, 0.75)];
        assert_eq!(composite(&layers, Rgb::gray(1.0), Transparency::Additive).r, 1.0);
    }

    #[test]
    fn layers_behind_the_opaque_surface_are_hidden() {
        let (mut layers, mut sorted) = (Layers::default(), Vec::new());
        layers.push(0, 1, layer(1.0, 5, 1.0, 0.5));
        layers.in_front(0, 2.0, 0, &mut sorted);
        assert!(sorted.is_empty());
        // Equal depth: in front only when it comes first in the list.
        layers.in_front(0, 1.0, 6, &mut sorted);
        assert_eq!(sorted.len(), 1);
        layers.in_front(0, 1.0, 4, &mut sorted);
        assert!(sorted.is_empty());
    }
}
