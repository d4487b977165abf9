//! From the options to a mesh: which criterion, which mode, and the walk of the observer.

use super::command::{CriterionName, MeasureName, ModeName, TerrainCommand, Wanted};
use super::covers::{BorderFigures, Covered};
use crate::cli::error::CliError;
use crate::forest::elevation::Grid;
use crate::forest::relief::borders::KeepingBorders;
use crate::forest::relief::budget::{Measure, with_triangles};
use crate::forest::relief::criterion::{Criterion, Factors, FromEye, Observer, Spheres, ThreeFactors};
use crate::forest::relief::fictitious::{self, Fictitious, Seams};
use crate::forest::relief::frontier::{Changes, Frontier};
use crate::forest::relief::{Hierarchy, Quality, ReliefMesh, mesh, quality};
use crate::report::{StageTime, StageTimer};
use crate::scene::Camera;

/// A relief, and what there is to tell about it.
pub(super) struct Made {
    pub mesh: ReliefMesh,
    pub quality: Quality,
    /// How it was asked for, in words.
    pub wanted: String,
    /// Selected and fictitious vertices, and edges with a vertex in their middle.
    pub fictitious: Option<(usize, usize, usize)>,
    /// Covers on it, and how well it keeps their borders.
    pub covered: Option<(Covered, BorderFigures)>,
    /// What every step of the walk changed, and the triangles after it.
    pub walk: Vec<(Changes, usize)>,
    /// Where the walk ended.
    pub camera: Camera,
    /// Measuring the errors, and making the mesh.
    pub times: [StageTime; 2],
}

impl Made {
    pub fn new(
        command: &TerrainCommand,
        grid: &Grid,
        camera: &Camera,
        covered: Option<Covered>,
    ) -> Result<Made, CliError> {
        let wanted = &command.wanted;
        check(command)?;
        let timer = StageTimer::start();
        let hierarchy = Hierarchy::new(grid);
        let errors = timer.stop();
        let timer = StageTimer::start();
        let mut made = Made {
            mesh: ReliefMesh::default(),
            quality: Quality::default(),
            wanted: String::new(),
            fictitious: None,
            covered: None,
            walk: Vec::new(),
            camera: *camera,
            times: [errors, StageTime::default()],
        };
        match (wanted.triangles, wanted.criterion) {
            (Some(triangles), _) => made.budget(&hierarchy, triangles, wanted.measure),
            (None, CriterionName::Error) => made.by_error(&hierarchy, wanted, covered.as_ref()),
            (None, CriterionName::View) => {
                made.by_view(&hierarchy, wanted, command.view.tolerance, covered.as_ref());
            }
            (None, CriterionName::Paper) => made.by_paper(&hierarchy, wanted, covered.as_ref()),
        }
        made.times[1] = timer.stop();
        made.quality = quality(grid, &made.mesh);
        made.covered = covered.map(|covered| {
            let figures = covered.figures(grid, &made.mesh);
            (covered, figures)
        });
        Ok(made)
    }

    fn budget(&mut self, hierarchy: &Hierarchy<'_>, triangles: u32, measure: MeasureName) {
        let (measure, name) = match measure {
            MeasureName::Squares => (Measure::Squares, "largest sum of squares first"),
            MeasureName::Largest => (Measure::Largest, "largest error first"),
        };
        self.wanted = format!("at most {triangles} triangles, {name}");
        self.mesh = with_triangles(hierarchy, triangles as usize, measure);
    }

    fn by_error(&mut self, hierarchy: &Hierarchy<'_>, wanted: &Wanted, covered: Option<&Covered>) {
        let (low, high) = hierarchy.grid.range().unwrap_or_default();
        let error = wanted.error.unwrap_or_else(|| f64::from(high - low) / 100.0);
        self.wanted = format!("at most {error} m off at every sample");
        if wanted.mode == ModeName::Conforming {
            let crosses =
                |middle| covered.is_some_and(|covered| f64::from(covered.borders.bound(middle)) > covered.tolerance);
            self.mesh = mesh::mesh(hierarchy, |middle| f64::from(hierarchy.bound(middle)) > error || crosses(middle));
        } else {
            self.take(fictitious::within(hierarchy, error, seams(wanted)));
        }
    }

    fn by_view(&mut self, hierarchy: &Hierarchy<'_>, wanted: &Wanted, tolerance: f64, covered: Option<&Covered>) {
        self.wanted = format!("at most {tolerance} px off as seen from the eye");
        let spheres = Spheres::new(hierarchy);
        self.follow(hierarchy, wanted, |camera| {
            let observer = Observer::new(camera, camera.resolution);
            keeping(FromEye { hierarchy, spheres: &spheres, observer, tolerance }, covered)
        });
    }

    fn by_paper(&mut self, hierarchy: &Hierarchy<'_>, wanted: &Wanted, covered: Option<&Covered>) {
        let (size, distance, curvature) = (wanted.size_factor, wanted.distance_factor, wanted.curvature_factor);
        let factors = Factors { size, distance, curvature };
        self.wanted = format!("the paper's factors: size {size}, distance {distance}, curvature {curvature}");
        let spheres = Spheres::new(hierarchy);
        let base = ThreeFactors::new(&spheres, factors, self.camera.from);
        self.follow(hierarchy, wanted, |camera| {
            let mut criterion = base.clone();
            criterion.move_to(camera.from);
            keeping(criterion, covered)
        });
    }

    /// The mesh of a criterion that depends on the eye, after a walk if there is one.
    fn follow<C: Criterion>(&mut self, hierarchy: &Hierarchy<'_>, wanted: &Wanted, criterion: impl Fn(&Camera) -> C) {
        let mut frontier = Frontier::new(hierarchy);
        let changes = frontier.follow(&criterion(&self.camera), usize::MAX);
        let start = self.camera;
        if let Some(end) = wanted.walk {
            self.walk.push((changes, frontier.mesh().triangles()));
            for step in 1..=wanted.steps {
                let way = (end - start.from) * (f64::from(step) / f64::from(wanted.steps));
                self.camera = Camera { from: start.from + way, at: start.at + way, ..start };
                let changes = frontier.follow(&criterion(&self.camera), usize::MAX);
                self.walk.push((changes, frontier.mesh().triangles()));
            }
        }
        if wanted.mode == ModeName::Conforming {
            self.mesh = frontier.mesh();
            return;
        }
        let criterion = criterion(&self.camera);
        let is_halved = |triangle: &crate::forest::relief::Triangle| criterion.score(triangle.middle()) > 1.0;
        self.take(fictitious::fictitious(hierarchy, is_halved, seams(wanted)));
    }

    fn take(&mut self, found: Fictitious) {
        self.fictitious = Some((found.selected, found.fictitious, found.junctions));
        self.mesh = found.mesh;
    }
}

/// A criterion that halves what crosses borders, too, wherever the observer is.
fn keeping<C>(criterion: C, covered: Option<&Covered>) -> KeepingBorders<'_, C> {
    let borders = covered.map(|covered| &covered.borders);
    KeepingBorders { criterion, borders, tolerance: covered.map_or(1.0, |covered| covered.tolerance) }
}

fn seams(wanted: &Wanted) -> Seams {
    if wanted.open { Seams::Open } else { Seams::Stitched }
}

/// Options that do not go together, beyond what the command line itself refuses.
fn check(command: &TerrainCommand) -> Result<(), CliError> {
    let wanted = &command.wanted;
    let by_eye = wanted.criterion != CriterionName::Error;
    let wrong = if wanted.error.is_some() && by_eye {
        "--error is a limit in metres; with --criterion view it is --tolerance PX, with paper the three factors"
    } else if wanted.walk.is_some() && !by_eye {
        "--walk moves the observer; say what depends on the observer: --criterion view, or --criterion paper"
    } else if wanted.open && wanted.mode == ModeName::Conforming {
        "--open leaves the T-junctions of fictitious vertices; add --mode fictitious"
    } else if wanted.criterion == CriterionName::View && command.view.tolerance == 0.0 {
        "--tolerance 0 asks for every triangle; write a number of pixels above 0, or --error 0"
    } else {
        return Ok(());
    };
    Err(CliError::failed(wrong))
}
