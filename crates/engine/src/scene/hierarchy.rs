//! The transform of a node, and the order in which the tree is evaluated.

use glam::{DAffine3, DMat3, DQuat, DVec3};

use super::node::{Node, Values};
use crate::error::{Error, Invalid, OutOfRange, Place, Result, TooMany, vec_with_room};
use crate::limits::MAX_LEVELS;
use crate::shared_list::SharedList;

/// L = T(position)·T(pivot)·R·S·T(−pivot).
pub(super) fn local(node: &Node, values: &Values) -> DAffine3 {
    let turn = DMat3::from_quat(values.rotation.normalize());
    let matrix3 = DMat3::from_cols(
        turn.x_axis * values.scale.x,
        turn.y_axis * values.scale.y,
        turn.z_axis * values.scale.z,
    );
    let translation = if node.pivot == DVec3::ZERO {
        values.position
    } else {
        values.position + node.pivot - matrix3 * node.pivot
    };
    DAffine3 {
        matrix3,
        translation,
    }
}

/// The rotation whose view is a matrix's z axis and whose up its y axis; zero axes are replaced.
pub(super) fn orthonormal(matrix: DMat3) -> DQuat {
    let usable = |v: DVec3| v.try_normalize().filter(|v| v.is_finite());
    let view = usable(matrix.z_axis)
        .or_else(|| usable(matrix.x_axis.cross(matrix.y_axis)))
        .unwrap_or(DVec3::Z);
    let across = |v: DVec3| {
        let v = usable(v)?;
        let rest = v - view * view.dot(v);
        (rest.length() > 1e-12).then(|| rest.normalize())
    };
    let up = across(matrix.y_axis)
        .or_else(|| across(matrix.x_axis).map(|x| view.cross(x)))
        .unwrap_or_else(|| crate::math::orientation::level_axes(view).1);
    crate::math::orientation::quaternion_from_view(view, up)
}

/// What must be evaluated before a node: its parent, and the parent of what it aims at.
pub(super) fn needs(nodes: &SharedList<Node>, node: usize) -> [Option<usize>; 2] {
    let aim = nodes[node].aim.and_then(|aim| nodes[aim].parent);
    [nodes[node].parent, aim]
}

/// The nodes in an order in which each comes after what it needs; an error with its node.
pub(super) fn order(nodes: &SharedList<Node>) -> Result<Vec<usize>, (usize, Error)> {
    let memory = |error| (0, error);
    let count = nodes.len();
    for (at, node) in nodes.iter().enumerate() {
        for (link, what) in [(node.parent, "parent"), (node.aim, "aim")] {
            if let Some(link) = link.filter(|&link| link >= count) {
                let error = Error::Range(OutOfRange::NoLink {
                    node: (&node.name).into(),
                    number: link,
                    count,
                    link: what,
                });
                return Err((at, error));
            }
        }
    }
    // 0: not seen, 1: on the way, 2: in the order.
    let mut marks = vec_with_room(count).map_err(memory)?;
    marks.resize(count, 0_u8);
    let mut levels = vec_with_room(count).map_err(memory)?;
    levels.resize(count, 1_usize);
    let mut order = vec_with_room(count).map_err(memory)?;
    let mut way: Vec<usize> = vec_with_room(count).map_err(memory)?;
    for root in 0..count {
        if marks[root] != 0 {
            continue;
        }
        way.push(root);
        while let Some(&node) = way.last() {
            marks[node] = 1;
            let open = needs(nodes, node).into_iter().flatten();
            match open.into_iter().find(|&needed| marks[needed] != 2) {
                Some(needed) if marks[needed] == 1 => {
                    return Err((node, cycle(nodes, node, needed)));
                }
                Some(needed) => way.push(needed),
                None => {
                    if let Some(parent) = nodes[node].parent {
                        levels[node] = levels[parent] + 1;
                    }
                    if levels[node] > MAX_LEVELS {
                        let error = Error::from(TooMany::Levels)
                            .at(Place::Node((&nodes[node].name).into()));
                        return Err((node, error));
                    }
                    marks[node] = 2;
                    order.push(node);
                    way.pop();
                }
            }
        }
    }
    Ok(order)
}

fn cycle(nodes: &SharedList<Node>, node: usize, needed: usize) -> Error {
    let name = |at: usize| nodes[at].name.as_str();
    Error::Argument(if nodes[node].parent == Some(needed) {
        Invalid::ParentMovesWithIt {
            node: name(node).into(),
            parent: name(needed).into(),
        }
    } else {
        Invalid::AimMovesWithIt {
            node: name(node).into(),
            parent: name(needed).into(),
        }
    })
}
