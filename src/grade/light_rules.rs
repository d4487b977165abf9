//! Light rules: everything the light of a lit sample is decided by, one field a decision.
//!
//! [`LightRules::default`] is the contract: Ka Ia C + sum I (Kd C max(0, N.L) + Ks max(0, R.V)^n), highlights only where N.L > 0.
//! [`super::lighting`] computes it under any of them; the mistakes with their words are in `mutants/light*.rs`.

/// Everything the light of a sample is decided by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightRules {
    /// Where light is computed.
    pub at: LitAt,
    /// Where the normal comes from.
    pub normal: NormalFrom,
    /// Signs of its x, y and z.
    pub signs: [f64; 3],
    /// What it is divided by.
    pub length: Length,
    /// Its numbers are rounded to parts of this size's inverse; 0: they are not.
    pub steps: f64,
    /// Where the point in eye space comes from.
    pub eye: EyeFrom,
    /// L.
    pub lamp: ToLamp,
    /// What L is divided by.
    pub lamp_length: Length,
    /// V.
    pub view: ToEye,
    /// What N.L becomes.
    pub cosine: Cosine,
    /// Where that goes.
    pub reach: Reach,
    /// Where there is a highlight.
    pub gate: Gate,
    /// Whose cosine the highlight is of.
    pub highlight: Highlight,
    /// What is done where that is negative.
    pub cut: Cut,
    /// The exponent.
    pub power: Power,
    /// Coefficients of ambient, diffuse and mirrored light.
    pub factors: [Factor; 3],
    /// What else the highlight is multiplied by.
    pub tint: Tint,
    /// How light fades with distance.
    pub fading: Fading,
    /// Which lamps count.
    pub lamps: Lamps,
    /// How the terms are put together.
    pub sum: Sum,
}

/// Where light is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LitAt {
    /// At the sample.
    Sample,
    /// At the corners, interpolated in space.
    Corners,
    /// At the corners, interpolated on the screen.
    CornersOnScreen,
    /// At that corner.
    Corner(usize),
    /// At the corner nearest to the eye.
    Nearest,
    /// The mean of the corners' light.
    Mean,
    /// At the middle of the corners.
    Middle,
}

/// Where the normal comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NormalFrom {
    /// Interpolated.
    Corners,
    /// That corner.
    Corner(usize),
    /// The corner nearest to the eye.
    Nearest,
    /// The corner with the greatest weight.
    Heaviest,
    /// The mean of the corners.
    Mean,
    /// The polygon's plane, towards the eye.
    Plane,
    /// (0, 0, -1).
    Fixed,
}

/// What a vector is divided by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Length {
    /// Its length.
    Unit,
    /// Nothing.
    AsIs,
    /// The sum of its numbers without signs.
    Sum,
    /// The greatest of its numbers.
    Greatest,
    /// The square of its length.
    Squared,
    /// The root of its length.
    Root,
}

/// Where the point in eye space comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EyeFrom {
    /// The sample.
    Sample,
    /// That corner.
    Corner(usize),
    /// The mean of the corners.
    Mean,
    /// Interpolated on the screen.
    Screen,
    /// Over w, as it is.
    OverW,
    /// Divided by 1/w twice.
    Twice,
}

/// L, the direction to the lamp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToLamp {
    /// Lamp minus point.
    FromPoint,
    /// Point minus lamp.
    Reversed,
    /// The lamp's place, as if seen from the eye.
    Position,
    /// Lamp plus point.
    Plus,
    /// The lamp stands at the eye.
    AtEye,
    /// With x, y or z of the lamp's place reversed.
    Flipped(usize),
}

/// V, the direction to the eye.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToEye {
    /// From the point, unit.
    FromPoint,
    /// As long as it is.
    NotUnit,
    /// (0, 0, -1).
    Fixed,
    /// From the eye to the point.
    Reversed,
    /// (0, 0, 1).
    FixedReversed,
    /// From the point to the lamp.
    Lamp,
}

/// What N.L becomes before it is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cosine {
    /// Itself, cut at 0.
    Plain,
    /// Its size.
    Absolute,
    /// Half of it and a half.
    Half,
    /// The square of that.
    HalfSquared,
    /// Its square, with its sign.
    Squared,
    /// Its root, with its sign.
    Root,
    /// Not cut at 0.
    Uncut,
    /// With the other sign.
    Reversed,
    /// 1 where it is positive.
    One,
    /// 1 - angle / 90 degrees.
    Angle,
    /// The sine.
    Sine,
}

/// Where a changed N.L goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Into diffuse light only.
    Diffuse,
    /// It also says where the highlight is.
    Gate,
    /// It is mirrored with as well.
    All,
}

/// Where there is a highlight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gate {
    /// Where N.L > 0.
    Lamp,
    /// Everywhere.
    Everywhere,
    /// Where N.V > 0.
    Eye,
    /// Where N.L < 0.
    Reversed,
}

/// Whose cosine the highlight is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Highlight {
    /// R.V, R = 2 (N.L) N - L.
    Mirrored,
    /// -R.V.
    Reversed,
    /// R = (N.L) N - L.
    WithoutTwo,
    /// R = 2 (N.L) N + L.
    Plus,
    /// R = 2 N - L.
    WithoutCosine,
    /// R = 2 (N.L) N.
    NothingTaken,
    /// R = 2 (N.L) L - N.
    AroundLamp,
    /// R = 2 (V.L) V - L.
    AroundView,
    /// N.H.
    Halfway,
    /// N.(L + V).
    HalfwayNotUnit,
    /// N.(L + V) / 2.
    HalfwayMean,
    /// N.V.
    Normal,
    /// L.V.
    Lamp,
    /// N.L.
    Diffuse,
    /// 1.
    Everywhere,
}

/// What is done where the highlight's cosine is negative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cut {
    /// It is 0.
    AtZero,
    /// It counts without its sign.
    Absolute,
    /// It is raised as it is.
    Not,
}

/// The exponent of the highlight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Power {
    /// n times this.
    Times(f64),
    /// n and this.
    Plus(f64),
    /// This.
    Fixed(f64),
    /// Multiplied by n, not raised.
    Multiplied,
    /// Raised with Ks: (Ks R.V)^n.
    WithCoefficient,
    /// N.L is raised, R.V is not.
    OnDiffuse,
    /// Both are.
    OnBoth,
    /// The root of n.
    Root,
}

/// A coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Factor {
    /// Its own.
    Own,
    /// Its own, times this.
    Times(f64),
    /// 1.
    One,
    /// That of ambient light.
    Ambient,
    /// That of diffuse light.
    Diffuse,
    /// That of the highlight.
    Specular,
    /// The exponent.
    Shine,
    /// Its square.
    Squared,
    /// The mean of its channels.
    Gray,
    /// 1 - itself.
    Rest,
}

/// What else the highlight is multiplied by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tint {
    /// Nothing.
    White,
    /// Kd C.
    Surface,
    /// Ka Ia C.
    Ambient,
    /// N.L.
    Cosine,
    /// The diffuse term.
    DiffuseTerm,
}

/// How light fades with the distance d of the lamp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fading {
    /// Not at all.
    None,
    /// 1/d.
    Inverse,
    /// 1/d^2.
    Square,
    /// 1/(1 + d).
    OneAndInverse,
    /// 1/(1 + d^2).
    OneAndSquare,
}

/// Which lamps count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lamps {
    /// All.
    All,
    /// The first.
    First,
    /// The last.
    Last,
    /// Their mean.
    Mean,
    /// Channel by channel the brightest.
    Brightest,
    /// All, with ambient light for each.
    AmbientEach,
    /// Each fades with what was added before it.
    FadeTogether,
    /// All, as if they were white.
    White,
    /// All, their highlights white.
    WhiteHighlights,
    /// All, their places at the first's.
    OnePlace,
}

/// How the terms are put together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sum {
    /// Added.
    All,
    /// Added, and multiplied by this.
    Times(f64),
    /// Divided by the sum of the coefficients.
    Normalized,
    /// Ambient light is multiplied by the lamps'.
    AmbientTimes,
    /// The greatest term.
    Greatest,
    /// Ambient light only where no lamp shines.
    AmbientInTheDark,
    /// Where no lamp shines there is nothing.
    DarkIsBlack,
    /// The highlight replaces diffuse light where it is.
    HighlightReplaces,
    /// Levels above 255 begin anew at 0.
    Wraps,
    /// Squared.
    Squared,
    /// 1 - light.
    Inverted,
}

impl Default for LightRules {
    /// The contract.
    fn default() -> Self {
        LightRules {
            at: LitAt::Sample,
            normal: NormalFrom::Corners,
            signs: [1.0; 3],
            length: Length::Unit,
            steps: 0.0,
            eye: EyeFrom::Sample,
            lamp: ToLamp::FromPoint,
            lamp_length: Length::Unit,
            view: ToEye::FromPoint,
            cosine: Cosine::Plain,
            reach: Reach::Diffuse,
            gate: Gate::Lamp,
            highlight: Highlight::Mirrored,
            cut: Cut::AtZero,
            power: Power::Times(1.0),
            factors: [Factor::Own; 3],
            tint: Tint::White,
            fading: Fading::None,
            lamps: Lamps::All,
            sum: Sum::All,
        }
    }
}
