//! The rows of the list: which nodes are seen in it, in which order, how deep. They are rebuilt
//! only when nodes, what is folded or the filter have changed.

use std::collections::HashSet;

use vides_engine::scene::{Node, Scene};
use vides_engine::shared_list::SharedList;

const NONE: usize = usize::MAX;

/// A node in the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Row {
    pub(super) node: usize,
    pub(super) level: usize,
    /// Whether what is in it is shown; none: nothing is in it.
    pub(super) open: Option<bool>,
}

#[derive(Debug, Default)]
pub(crate) struct Rows {
    rows: Vec<Row>,
    /// [`vides_document::EditedScene::number`] of what they show.
    made_of: Option<u64>,
    /// By name, which a node keeps whatever number it gets.
    folded: HashSet<String>,
    /// What names must contain, in small letters.
    wanted: String,
}

impl Rows {
    pub(super) fn all(&self) -> &[Row] {
        &self.rows
    }

    /// The row of a node, if it is seen.
    pub(super) fn of(&self, node: usize) -> Option<usize> {
        self.rows.iter().position(|row| row.node == node)
    }

    /// Brings them up to date with a scene of this number.
    pub(super) fn update(&mut self, scene: &Scene, number: u64) {
        if self.made_of != Some(number) {
            self.made_of = Some(number);
            self.make(scene.nodes());
        }
    }

    /// Shows only nodes whose names contain this, and what they are in.
    pub(super) fn filter(&mut self, text: &str) {
        let wanted = text.trim().to_lowercase();
        if self.wanted != wanted {
            self.wanted = wanted;
            self.made_of = None;
        }
    }

    /// Folds a node of this name, or unfolds it.
    pub(super) fn fold(&mut self, name: &str, folds: bool) {
        let changed = match folds {
            true => self.folded.insert(name.to_owned()),
            false => self.folded.remove(name),
        };
        if changed {
            self.made_of = None;
        }
    }

    /// A node that is folded stays so under its new name.
    pub(super) fn rename(&mut self, from: &str, to: &str) {
        if self.folded.remove(from) {
            self.folded.insert(to.to_owned());
        }
    }

    /// Unfolds all that a node is in.
    pub(super) fn unfold_to(&mut self, nodes: &SharedList<Node>, node: usize) {
        let parent = |at: usize| nodes.get(at).and_then(|node| node.parent);
        for at in std::iter::successors(parent(node), |&up| parent(up)) {
            self.fold(&nodes[at].name, false);
        }
    }

    /// Which nodes the filter leaves; none: all.
    fn left(&self, nodes: &SharedList<Node>) -> Option<Vec<bool>> {
        if self.wanted.is_empty() {
            return None;
        }
        let mut left = vec![false; nodes.len()];
        for (at, node) in nodes.iter().enumerate() {
            if !node.name.to_lowercase().contains(&self.wanted) {
                continue;
            }
            let above = std::iter::successors(Some(at), |&up| nodes[up].parent);
            for at in above {
                if std::mem::replace(&mut left[at], true) {
                    break;
                }
            }
        }
        Some(left)
    }

    fn make(&mut self, nodes: &SharedList<Node>) {
        let left = self.left(nodes);
        let count = nodes.len();
        // The nodes in each one, those of the scene itself last: the first, and the next ones.
        let (mut first, mut next) = (vec![NONE; count + 1], vec![NONE; count]);
        for at in (0..count).rev() {
            if left.as_ref().is_none_or(|left| left[at]) {
                let parent = nodes[at].parent.unwrap_or(count);
                next[at] = std::mem::replace(&mut first[parent], at);
            }
        }
        self.rows.clear();
        let mut above: Vec<usize> = Vec::new();
        let mut at = first[count];
        loop {
            while at == NONE {
                let Some(up) = above.pop() else {
                    return;
                };
                at = next[up];
            }
            // What is looked for is not hidden.
            let folds = left.is_none() && self.folded.contains(&nodes[at].name);
            let open = (first[at] != NONE).then_some(!folds);
            self.rows.push(Row {
                node: at,
                level: above.len(),
                open,
            });
            if open == Some(true) {
                above.push(at);
                at = first[at];
            } else {
                at = next[at];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use vides_engine::scene::Kind;

    use super::*;

    /// A node's name with its parent's number.
    fn scene(nodes: &[(&str, Option<usize>)]) -> Scene {
        let nodes = nodes.iter().map(|&(name, parent)| {
            let mut node = Node::new(name, Kind::Group);
            node.parent = parent;
            node
        });
        Scene::from_nodes(nodes.collect()).unwrap()
    }

    fn shown(rows: &Rows, scene: &Scene) -> Vec<String> {
        let name = |row: &Row| {
            let sign = match row.open {
                None => "",
                Some(true) => "-",
                Some(false) => "+",
            };
            let name = &scene.nodes()[row.node].name;
            format!("{}{sign}{name}", " ".repeat(row.level))
        };
        rows.all().iter().map(name).collect()
    }

    /// Some stand before what they are in.
    fn car() -> Scene {
        scene(&[
            ("wheel", Some(2)),
            ("lamp", None),
            ("car", None),
            ("hub", Some(0)),
            ("Wheel 2", Some(2)),
        ])
    }

    #[test]
    fn each_node_stands_below_what_it_is_in() {
        let scene = car();
        let mut rows = Rows::default();
        rows.update(&scene, 1);
        let all = ["lamp", "-car", " -wheel", "  hub", " Wheel 2"];
        assert_eq!(shown(&rows, &scene), all);
        rows.fold("wheel", true);
        rows.update(&scene, 1);
        assert_eq!(
            shown(&rows, &scene),
            ["lamp", "-car", " +wheel", " Wheel 2"]
        );
        rows.fold("car", true);
        rows.update(&scene, 1);
        assert_eq!(shown(&rows, &scene), ["lamp", "+car"]);
        rows.unfold_to(scene.nodes(), 3);
        rows.update(&scene, 1);
        assert_eq!(shown(&rows, &scene), all);
    }

    #[test]
    fn a_filter_leaves_what_it_finds_and_what_that_is_in() {
        let scene = car();
        let mut rows = Rows::default();
        rows.fold("car", true);
        rows.filter(" WHEEL");
        rows.update(&scene, 1);
        assert_eq!(shown(&rows, &scene), ["-car", " wheel", " Wheel 2"]);
        rows.filter("hub");
        rows.update(&scene, 1);
        assert_eq!(shown(&rows, &scene), ["-car", " -wheel", "  hub"]);
        rows.filter("nothing");
        rows.update(&scene, 1);
        assert_eq!(shown(&rows, &scene), [""; 0]);
        rows.filter("");
        rows.update(&scene, 1);
        assert_eq!(shown(&rows, &scene), ["lamp", "+car"]);
    }

    /// What is folded is so under its name, and under its next one.
    #[test]
    fn what_is_folded_stays_so_when_numbers_and_names_change() {
        let mut rows = Rows::default();
        rows.fold("car", true);
        let scene = car();
        rows.update(&scene, 1);
        assert_eq!(shown(&rows, &scene), ["lamp", "+car"]);
        let fewer = self::scene(&[("car", None), ("wheel", Some(0))]);
        rows.update(&fewer, 2);
        assert_eq!(shown(&rows, &fewer), ["+car"]);
        rows.rename("car", "van");
        let renamed = self::scene(&[("van", None), ("wheel", Some(0))]);
        rows.update(&renamed, 3);
        assert_eq!(shown(&rows, &renamed), ["+van"]);
    }
}
