//! The fewest pictures that show a share of a surface: always the one that adds most (within ln n
//! of the best: Feige 1998), then those go that the others make needless. Gains only fall, so one
//! that still leads after a recount is the greatest (Minoux 1978).

use super::seen::{Set, members};
use crate::error::{Result, vec_with_room};

/// Which sets to take until their area together is `wanted`, or nothing more is gained.
pub(super) fn fewest(sets: &[Set], areas: &[f64], wanted: f64) -> Result<Vec<usize>> {
    let mut gains: Vec<f64> = vec_with_room(sets.len())?;
    gains.resize(sets.len(), f64::INFINITY);
    let words = areas.len().div_ceil(64);
    let mut covered: Set = vec_with_room(words)?;
    covered.resize(words, 0);
    let mut chosen = vec_with_room(sets.len())?;
    let mut area = 0.0;
    while area < wanted {
        // The first of the greatest.
        let Some(best) = (0..sets.len())
            .rev()
            .max_by(|a, b| gains[*a].total_cmp(&gains[*b]))
        else {
            break;
        };
        let gain = gain(&sets[best], &covered, areas);
        let leads = gains
            .iter()
            .enumerate()
            .all(|(at, other)| at == best || *other <= gain);
        gains[best] = gain;
        if !leads {
            continue;
        }
        if !(gain > 0.0) {
            break;
        }
        chosen.push(best);
        area += gain;
        gains[best] = 0.0;
        covered
            .iter_mut()
            .zip(&sets[best])
            .for_each(|(all, own)| *all |= own);
    }
    drop_needless(sets, areas, wanted.min(area), &mut chosen)?;
    Ok(chosen)
}

fn gain(set: &Set, covered: &Set, areas: &[f64]) -> f64 {
    let mut sum = 0.0;
    for (word, (own, all)) in set.iter().zip(covered).enumerate() {
        let mut left = own & !all;
        while left != 0 {
            sum += areas[64 * word + left.trailing_zeros() as usize];
            left &= left - 1;
        }
    }
    sum
}

/// Takes away, the last first, what is not needed for the area.
fn drop_needless(sets: &[Set], areas: &[f64], wanted: f64, chosen: &mut Vec<usize>) -> Result<()> {
    let mut times: Vec<u16> = vec_with_room(areas.len())?;
    times.resize(areas.len(), 0);
    let count = |times: &mut Vec<u16>, set: &Set, add: bool| {
        members(set).for_each(|at| {
            times[at] = if add {
                times[at].saturating_add(1)
            } else {
                times[at] - 1
            };
        });
    };
    chosen
        .iter()
        .for_each(|at| count(&mut times, &sets[*at], true));
    let mut area: f64 = (0..areas.len())
        .filter(|at| times[*at] > 0)
        .map(|at| areas[at])
        .sum();
    for k in (0..chosen.len()).rev() {
        let own = &sets[chosen[k]];
        let alone: f64 = members(own)
            .filter(|at| times[*at] == 1)
            .map(|at| areas[at])
            .sum();
        // Sums of another order differ by rounding.
        if area - alone >= wanted * (1.0 - 1e-12) {
            area -= alone;
            count(&mut times, own, false);
            chosen.remove(k);
        }
    }
    Ok(())
}
