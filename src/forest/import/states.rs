//! States: from the rows of a stand to what it is, year by year.
//!
//! records of a stand -STATES-> its states, years ascending
//!
//! Cut and burnt stands have no trees, and a ground that shows why (`slash`, `burnt`). What is replanted is small and dense, and has a state every few years
//! until the table knows better. A plan (`--cut`, `--burn`, `--replant`, `--plan`) goes before the table: what the table says of its year and later is left out.
//!
//! Space: metres, trees a hectare, years.

use super::kinds::{Kinds, Usual, tenth, usual};
use super::record::{Growth, Record, What};
use crate::forest::area::{Form, Plant, Spread, StandState};

/// Ground below a stand that was cut, and below one that burnt.
const BARE: [&str; 2] = ["slash", "burnt"];
/// Years after planting in which a stand gets a state.
const AGES: [i32; 9] = [0, 2, 4, 7, 10, 15, 20, 30, 45];

/// The states of a stand: rows of the table, and those of a plan. Also how many rows of the table the plan left out.
pub(super) fn states(table: &[&Record], plan: &[&Record], kinds: &mut Kinds) -> (Vec<StandState>, usize) {
    let planned = plan.iter().filter_map(|record| record.year).min();
    let stays = |record: &&Record| planned.is_none_or(|year| record.year.is_none_or(|own| own < year));
    let mut rows: Vec<&Record> = table.iter().copied().filter(stays).collect();
    let left_out = table.len() - rows.len();
    rows.extend(plan);
    rows.sort_by_key(|record| record.year);
    let first_known = rows.iter().find_map(|record| record.year);
    let mut states: Vec<StandState> = Vec::new();
    for (index, record) in rows.iter().enumerate() {
        // What always was, was the year before anything happened.
        let year = record.year.or(first_known.map(|year| year.saturating_sub(1)));
        let next = rows.get(index + 1).and_then(|record| record.year);
        match &record.what {
            What::Grows(growth) => states.push(measured(growth, year, kinds)),
            What::Cut => states.push(bare(states.last(), year, BARE[0], kinds)),
            What::Burnt => states.push(bare(states.last(), year, BARE[1], kinds)),
            What::Replanted { species, form } => planted(species, *form, [year, next], kinds, &mut states),
        }
    }
    (states, left_out)
}

fn measured(growth: &Growth, year: Option<i32>, kinds: &mut Kinds) -> StandState {
    let species = kinds.species(&growth.species, growth.form);
    let usual = usual(kinds.form(species));
    let cover = growth.cover.clone().unwrap_or_else(|| usual.cover.to_string());
    StandState {
        year,
        species,
        height: growth.height,
        crown: growth.crown.unwrap_or_else(|| crown(&usual, growth.height)),
        density: growth.density,
        crown_base: growth.crown_base,
        plant: growth.plant,
        picture: None,
        cover: Some(kinds.cover(&cover)),
    }
}

/// The usual crown of trees of a height; crowns differ as much as heights do.
fn crown(usual: &Usual, height: Spread) -> Spread {
    let mean = usual.crown(height.mean);
    Spread { mean: tenth(mean).max(0.1), deviation: tenth(mean * height.deviation / height.mean) }
}

/// No trees, and a ground.
fn bare(before: Option<&StandState>, year: Option<i32>, cover: &str, kinds: &mut Kinds) -> StandState {
    let cover = Some(kinds.cover(cover));
    match before {
        Some(before) => StandState { year, density: 0.0, cover, picture: None, ..before.clone() },
        None => StandState {
            year,
            species: kinds.species("bare", Some(Form::Shrub)),
            height: Spread { mean: 1.0, deviation: 0.0 },
            crown: Spread { mean: 1.0, deviation: 0.0 },
            density: 0.0,
            crown_base: None,
            plant: Plant::Poisson,
            picture: None,
            cover,
        },
    }
}

/// Small trees, and what they grow to until `next`.
fn planted(
    code: &str,
    form: Option<Form>,
    [year, next]: [Option<i32>; 2],
    kinds: &mut Kinds,
    states: &mut Vec<StandState>,
) {
    let species = kinds.species(code, form);
    let usual = usual(kinds.form(species));
    let begin = year.unwrap_or(0);
    for age in AGES {
        let at = begin.saturating_add(age);
        if age > 0 && (year.is_none() || next.is_some_and(|next| at >= next)) {
            break;
        }
        let (mean, density) = usual.grown(f64::from(age));
        let height = Spread { mean, deviation: tenth(0.1 * mean) };
        let plant = Plant::Jittered;
        let cover = Some(kinds.cover(if age < 7 { "heath" } else { usual.cover }));
        let (year, crown) = (year.map(|_| at), crown(&usual, height));
        states.push(StandState {
            year,
            species,
            height,
            crown,
            density,
            crown_base: None,
            plant,
            picture: None,
            cover,
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(year: Option<i32>, what: What) -> Record {
        Record { stand: "7".to_string(), year, what, origin: String::new() }
    }

    fn grows(height: f64) -> What {
        What::Grows(Growth {
            species: "PINPR".to_string(),
            form: None,
            height: Spread { mean: height, deviation: 1.0 },
            crown: None,
            density: 500.0,
            crown_base: None,
            plant: Plant::Poisson,
            cover: None,
        })
    }

    /// Year, height, density and ground of each state.
    type Told = (Option<i32>, f64, f64, String);

    fn told(table: &[Record], plan: &[Record]) -> (Vec<Told>, usize) {
        let mut kinds = Kinds::default();
        let (states, left_out) =
            states(&table.iter().collect::<Vec<_>>(), &plan.iter().collect::<Vec<_>>(), &mut kinds);
        let cover = |state: &StandState| kinds.covers[usize::from(state.cover.expect("a ground"))].image.clone();
        (states.iter().map(|state| (state.year, state.height.mean, state.density, cover(state))).collect(), left_out)
    }

    #[test]
    fn cut_burnt_and_replanted_are_seen() {
        let table = [record(None, grows(20.0)), record(Some(2018), What::Cut)];
        let (found, _) = told(&table, &[]);
        let pine = "paint:pine_floor".to_string();
        assert_eq!(
            found,
            [(Some(2017), 20.0, 500.0, pine.clone()), (Some(2018), 20.0, 0.0, "paint:slash".to_string())]
        );
        let species = "EUCGL".to_string();
        let plan = [record(Some(2020), What::Burnt), record(Some(2022), What::Replanted { species, form: None })];
        let (found, left_out) = told(&[record(Some(2011), grows(20.0)), record(Some(2026), grows(25.0))], &plan);
        assert_eq!(left_out, 1);
        let years: Vec<_> = found.iter().filter_map(|state| state.0).collect();
        assert_eq!(years, [2011, 2020, 2022, 2024, 2026, 2029, 2032, 2037, 2042, 2052, 2067]);
        assert_eq!((found[1].2, found[1].3.as_str()), (0.0, "paint:burnt"));
        assert!(found[2..].windows(2).all(|pair| pair[0].1 < pair[1].1));
    }

    #[test]
    fn what_was_planted_grows_until_the_table_knows_better() {
        let species = "PINPR".to_string();
        let table = [record(Some(2000), What::Replanted { species, form: None }), record(Some(2008), grows(6.0))];
        let (found, _) = told(&table, &[]);
        assert_eq!(found.iter().filter_map(|state| state.0).collect::<Vec<_>>(), [2000, 2002, 2004, 2007, 2008]);
        assert_eq!(told(&[record(None, grows(9.0))], &[]).0[0].0, None);
    }
}
