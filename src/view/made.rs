//! Made: lists, samples and pictures that drawing asks for, made once and kept while nothing they depend on changes.
//!
//! scene, choices, camera -MADE-> DrawList, trace, samples, Image
//!
//! Why a wish as the key: whoever adds a choice cannot forget to throw something away, since choices are compared as a whole.
//! Why `Rc`: several things are looked at together, and each may have been made at another time.
//!
//! Cost: one of each is kept; lists and pictures reuse the memory of the one before.

use super::stages::Traced;
use crate::geometry;
use crate::image::Image;
use crate::plan::{Choices, Plan, Shading};
use crate::raster::{Frame, PutCounts, Rasterizer, Wire, ZBuffer};
use crate::render::{self, Canvas};
use crate::report::Counts;
use crate::scene::{Camera, Scene};
use crate::screen::DrawList;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;

/// A rasterizer and its name.
pub type Named<'a> = (String, &'a dyn Rasterizer);

/// Everything that something made depends on.
#[derive(Clone, Debug, PartialEq)]
pub struct Wish {
    /// Seen from here.
    pub camera: Camera,
    /// Made so.
    pub choices: Choices,
    /// By this one.
    pub rasterizer: usize,
    /// Which reading of the scene.
    pub version: u64,
}

/// What the geometry stage made.
#[derive(Debug)]
pub struct Listed {
    /// Needs and view.
    pub plan: Plan,
    /// The polygons on the screen.
    pub list: DrawList,
    /// What was counted.
    pub counts: Counts,
}

/// A picture, and what was put for it.
#[derive(Debug)]
pub struct Pictured {
    /// Linear light.
    pub image: Image,
    /// What the rasterizer counted.
    pub puts: PutCounts,
}

/// What is in front at every sample.
#[derive(Debug, Default)]
pub struct Samples {
    frame: Frame,
    /// Samples across.
    pub width: usize,
    /// Samples down.
    pub height: usize,
}

impl Samples {
    /// The polygon in front at a sample of the picture, and its depth; larger is nearer, 0 is infinitely far.
    #[must_use]
    pub fn at(&self, x: usize, y: usize) -> (Option<u32>, f64) {
        if x >= self.width || y >= self.height {
            return (None, 0.0);
        }
        let (owner, depth, _) = self.frame.sample(y * self.width + x);
        (owner, depth)
    }
}

/// The last thing of its kind.
#[derive(Debug)]
struct Kept<T>(Option<(Wish, Rc<T>)>);

impl<T> Kept<T> {
    /// The one for this wish; made, perhaps in the memory of the last one, when that was for another.
    fn of(&mut self, wish: &Wish, make: impl FnOnce(Option<T>) -> Result<T, String>) -> Result<Rc<T>, String> {
        if let Some((kept, thing)) = &self.0
            && kept == wish
        {
            return Ok(thing.clone());
        }
        let last = self.0.take().and_then(|(_, last)| Rc::try_unwrap(last).ok());
        let thing = Rc::new(make(last)?);
        self.0 = Some((wish.clone(), thing.clone()));
        Ok(thing)
    }
}

/// Makes what is asked for, from a scene.
pub struct Maker<'a> {
    /// What is looked at.
    pub scene: Scene,
    /// The rasterizers to choose from; the first is the one that was asked for.
    pub rasterizers: Vec<Named<'a>>,
    listed: Kept<Listed>,
    traced: Kept<Traced>,
    pictured: Kept<Pictured>,
    reference: Kept<Pictured>,
    samples: Kept<Samples>,
}

impl<'a> Maker<'a> {
    /// Nothing is made yet.
    #[must_use]
    pub fn new(scene: Scene, rasterizers: Vec<Named<'a>>) -> Maker<'a> {
        let (listed, traced, samples) = (Kept(None), Kept(None), Kept(None));
        Maker { scene, rasterizers, listed, traced, pictured: Kept(None), reference: Kept(None), samples }
    }

    /// The rasterizer of a wish; lines are drawn by the one that draws lines.
    #[must_use]
    pub fn rasterizer(&self, wish: &Wish) -> &'a dyn Rasterizer {
        let chosen = self.rasterizers.get(wish.rasterizer).map_or(&ZBuffer as &dyn Rasterizer, |named| named.1);
        if wish.choices.shading == Shading::Wire { &crate::raster::PerPolygon(Wire) } else { chosen }
    }

    /// The draw list.
    ///
    /// # Errors
    /// What the plan refuses.
    pub fn listed(&mut self, wish: &Wish) -> Result<Rc<Listed>, String> {
        let accepts = self.rasterizer(wish).accepts();
        self.scene.camera = Some(wish.camera);
        let scene = &self.scene;
        self.listed.of(wish, |last| {
            let plan = Plan::new(scene, &wish.choices, accepts).map_err(|error| error.to_string())?;
            let mut list = last.map_or_else(|| DrawList::new(0, 0), |last| last.list);
            let counts = geometry::run(scene, &plan, &mut list);
            Ok(Listed { plan, list, counts })
        })
    }

    /// The draw list, and what passed between the stages. Lines have no stages of their own: for them the list of areas is traced.
    ///
    /// # Errors
    /// As [`Maker::listed`].
    pub fn traced(&mut self, wish: &Wish) -> Result<Rc<Traced>, String> {
        let accepts = self.rasterizer(wish).accepts();
        self.scene.camera = Some(wish.camera);
        let scene = &self.scene;
        self.traced.of(wish, |_| {
            let plan = Plan::new(scene, &wish.choices, accepts).map_err(|error| error.to_string())?;
            Ok(Traced::new(scene, plan))
        })
    }

    /// The picture.
    ///
    /// # Errors
    /// As [`Maker::listed`]; a rasterizer that panicked, or gave no picture.
    pub fn pictured(&mut self, wish: &Wish) -> Result<Rc<Pictured>, String> {
        let listed = self.listed(wish)?;
        let canvas = Canvas::new(&self.scene, &wish.choices);
        let rasterizer = self.rasterizer(wish);
        self.pictured.of(wish, |last| picture(&listed.list, rasterizer, &canvas, last))
    }

    /// The picture that the z-buffer draws.
    ///
    /// # Errors
    /// As [`Maker::listed`].
    pub fn reference(&mut self, wish: &Wish) -> Result<Rc<Pictured>, String> {
        self.scene.camera = Some(wish.camera);
        let (scene, canvas) = (&self.scene, Canvas::new(&self.scene, &wish.choices));
        let lines: &dyn Rasterizer = &crate::raster::PerPolygon(Wire);
        let right = if wish.choices.shading == Shading::Wire { lines } else { &ZBuffer };
        self.reference.of(wish, |last| {
            let list = render::list(scene, &wish.choices, Some(right)).map_err(|error| error.to_string())?;
            picture(&list, right, &canvas, last)
        })
    }

    /// What is in front, as the wish's rasterizer says.
    ///
    /// # Errors
    /// As [`Maker::pictured`].
    pub fn samples(&mut self, wish: &Wish) -> Result<Rc<Samples>, String> {
        let listed = self.listed(wish)?;
        let canvas = Canvas::new(&self.scene, &wish.choices);
        let rasterizer = self.rasterizer(wish);
        self.samples.of(wish, |last| samples(&listed.list, rasterizer, &canvas, last))
    }
}

fn picture(
    list: &DrawList,
    rasterizer: &dyn Rasterizer,
    canvas: &Canvas,
    last: Option<Pictured>,
) -> Result<Pictured, String> {
    let size = ((list.width / canvas.samples) as usize, (list.height / canvas.samples) as usize);
    let last = last.map(|last| last.image).filter(|image| (image.width(), image.height()) == size);
    let mut image = last.unwrap_or_else(|| Image::new(size.0, size.1, canvas.background));
    let drawn = carefully(|| match render::draw_pixels(list, rasterizer, canvas, &mut image) {
        Some(puts) => (None, puts),
        None => {
            let (image, puts) = render::draw(list, Some(rasterizer), canvas);
            (Some(image), puts)
        }
    })?;
    let (other, puts) = drawn;
    puts.failure.clone().map_or(Ok(()), Err)?;
    Ok(Pictured { image: other.unwrap_or(image), puts })
}

fn samples(
    list: &DrawList,
    rasterizer: &dyn Rasterizer,
    canvas: &Canvas,
    last: Option<Samples>,
) -> Result<Samples, String> {
    let mut samples = last.unwrap_or_default();
    (samples.width, samples.height) = (list.width as usize, list.height as usize);
    let size = (list.width, list.height);
    let target = samples.frame.target(size, 0..list.height, canvas.background, canvas.transparency);
    let mut target = target.with_threads(canvas.threads);
    carefully(|| rasterizer.draw(list, &mut target))?;
    target.finish().failure.map_or(Ok(()), Err)?;
    Ok(samples)
}

/// A student's rasterizer may panic; the window stays.
pub(super) fn carefully<T>(draw: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(draw)).map_err(|panic| {
        let said = panic.downcast_ref::<String>().map(String::as_str);
        let said = said.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("nothing was said");
        format!("the rasterizer panicked: {said}")
    })
}
