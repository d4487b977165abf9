//! Tour: a path over places on the map, made without a window.
//!
//! places -TOUR-> poses, one a frame -> [`path`](super::path)
//!
//! The eye goes from place to place in straight lines at one speed and looks at where it will be some metres later: so it turns
//! before a corner, not at it. Heights follow a ground that the caller knows.
//!
//! Space: world, metres, z up.

use super::path::Pose;
use crate::math::Vec3;

/// More frames are refused, as in a path: ten hours at 30 a second.
const MOST: f64 = (1 << 20) as f64;

/// A tour to be.
#[derive(Clone, Debug, PartialEq)]
pub struct Tour {
    /// Where it leads, in order; z is what the ground function makes of it.
    pub places: Vec<Vec3>,
    /// Metres a frame; above 0.
    pub stride: f64,
    /// The eye looks this many metres ahead along the way; above 0.
    pub ahead: f64,
}

/// Why there is no tour.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum TourError {
    /// Nowhere to go.
    #[error("a walk needs two different places at least, as in \"100 100 1.7 400 900 1.7\"")]
    TooShort,
    /// More frames than a path may have.
    #[error("the walk is {metres:.0} m long: {frames:.0} frames are more than {MOST}; go faster")]
    TooLong {
        /// Along the way.
        metres: f64,
        /// At this stride.
        frames: f64,
    },
}

impl Tour {
    /// The poses, first and last place included. `lift` turns a place of the way, its z between those of the places, into the eye
    /// there: adds the ground below, or not.
    ///
    /// # Errors
    /// [`TourError`] without two different places, and for tours without end.
    pub fn poses(&self, mut lift: impl FnMut(Vec3) -> Vec3) -> Result<Vec<Pose>, TourError> {
        // A place twice is one place; distances are those of the map, or a climb would slow the eye down.
        let mut places: Vec<Vec3> = Vec::new();
        for &place in &self.places {
            if places.last().is_none_or(|last| last.truncate() != place.truncate()) {
                places.push(place);
            }
        }
        let lengths: Vec<f64> = places.windows(2).map(|pair| pair[0].truncate().distance(pair[1].truncate())).collect();
        let metres: f64 = lengths.iter().sum();
        if lengths.is_empty() || !(metres > 0.0 && self.stride > 0.0) {
            return Err(TourError::TooShort);
        }
        let frames = (metres / self.stride).ceil() + 1.0;
        if frames.is_nan() || frames > MOST {
            return Err(TourError::TooLong { metres, frames });
        }
        let way = Way { places, lengths };
        let pose = |frame: u64| {
            let along = (frame as f64 * self.stride).min(metres);
            let (from, at) = (lift(way.place(along)), lift(way.place(along + self.ahead.max(self.stride))));
            // Ahead of a sharp turn back is the eye itself.
            let at = if from.truncate() == at.truncate() { from + way.direction(along) } else { at };
            Pose { from, at, up: Vec3::Z }
        };
        Ok((0..frames as u64).map(pose).collect())
    }
}

/// Straight lines one after another.
struct Way {
    places: Vec<Vec3>,
    lengths: Vec<f64>,
}

impl Way {
    /// The line that goes on after so many metres, and how much of it is behind; the last line goes on without end.
    fn line(&self, mut along: f64) -> (usize, f64) {
        let last = self.lengths.len() - 1;
        for (index, length) in self.lengths[..last].iter().enumerate() {
            if along < *length {
                return (index, along / length);
            }
            along -= length;
        }
        (last, along / self.lengths[last])
    }

    fn place(&self, along: f64) -> Vec3 {
        let (index, share) = self.line(along);
        let (start, end) = (self.places[index], self.places[index + 1]);
        let place = start + (end - start) * share;
        // Beyond the end the way goes on level.
        Vec3::new(place.x, place.y, start.z + (end.z - start.z) * share.min(1.0))
    }

    /// One metre along the line at `along`, level.
    fn direction(&self, along: f64) -> Vec3 {
        let (index, _) = self.line(along);
        let way = self.places[index + 1] - self.places[index];
        Vec3::new(way.x, way.y, 0.0) / self.lengths[index]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tour(places: &[[f64; 3]], stride: f64, ahead: f64) -> Tour {
        Tour { places: places.iter().map(|&place| Vec3::from(place)).collect(), stride, ahead }
    }

    #[test]
    fn a_tour_goes_through_its_places_at_one_speed() {
        let corner = tour(&[[0.0, 0.0, 2.0], [30.0, 0.0, 2.0], [30.0, 40.0, 12.0]], 0.5, 8.0);
        let poses = corner.poses(|place| place + Vec3::new(0.0, 0.0, 100.0)).expect("a tour");
        assert_eq!(poses.len(), 141);
        assert_eq!((poses[0].from, poses[0].at), (Vec3::new(0.0, 0.0, 102.0), Vec3::new(8.0, 0.0, 102.0)));
        assert_eq!((poses[60].from, poses[140].from), (Vec3::new(30.0, 0.0, 102.0), Vec3::new(30.0, 40.0, 112.0)));
        // Seven metres before the corner it looks one metre round it; after the end it looks straight on.
        assert_eq!((poses[46].at, poses[140].at), (Vec3::new(30.0, 1.0, 102.25), Vec3::new(30.0, 48.0, 112.0)));
        let strides = poses.windows(2).map(|pair| pair[0].from.truncate().distance(pair[1].from.truncate()));
        assert!(strides.into_iter().all(|stride| (stride - 0.5).abs() < 1e-9));
    }

    #[test]
    fn the_eye_always_looks_somewhere() {
        let there_and_back = tour(&[[0.0, 0.0, 1.0], [10.0, 0.0, 1.0], [10.0, 0.0, 1.0], [0.0, 0.0, 1.0]], 1.0, 4.0);
        let poses = there_and_back.poses(|place| place).expect("a tour");
        assert!(poses.len() == 21 && poses.iter().all(|pose| pose.from != pose.at));
    }

    #[test]
    fn nowhere_and_for_ever_are_no_tours() {
        let same = tour(&[[1.0, 1.0, 1.0], [1.0, 1.0, 5.0]], 1.0, 1.0);
        assert_eq!(same.poses(|place| place), Err(TourError::TooShort));
        assert_eq!(tour(&[], 1.0, 1.0).poses(|place| place), Err(TourError::TooShort));
        let long = tour(&[[0.0; 3], [1e9, 0.0, 0.0]], 0.1, 1.0);
        assert!(matches!(long.poses(|place| place), Err(TourError::TooLong { .. })));
    }
}
