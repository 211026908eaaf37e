//! Nodes that come into a scene and go out of it.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use super::hierarchy;
use super::node::Node;
use super::removal::Removal;
use super::scene::{Scene, check_count, check_node, check_numbers, taken};
use crate::error::{Error, OutOfRange, Place, Result, vec_with_room};
use crate::shared_list::SharedList;

/// Which node of a scene it is, whatever its number: it stays when others come and go, in copies of
/// the scene, too.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(u64);

impl NodeId {
    /// That of the camera in the scene of a path alone ([`Scene::of_path`]).
    pub const OF_PATH: Self = Self(0);

    /// One that no other node of this process has.
    pub(super) fn fresh() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(1);
        // Unique and rising, which needs no order among threads: a scene is one thread's.
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }
}

/// Gives parents and aims other numbers; nodes whose links stay are not touched.
pub(super) fn renumber(nodes: &mut SharedList<Node>, number: impl Fn(usize) -> Option<usize>) {
    for at in 0..nodes.len() {
        let node = &nodes[at];
        let links = (node.parent.and_then(&number), node.aim.and_then(&number));
        if links != (node.parent, node.aim) {
            let node = &mut nodes[at];
            (node.parent, node.aim) = links;
        }
    }
}

impl Scene {
    /// Which nodes these are, by their numbers, rising.
    #[must_use]
    pub fn ids(&self) -> &[NodeId] {
        &self.ids
    }

    /// The number of a node; none if it was removed.
    #[must_use]
    pub fn number_of(&self, id: NodeId) -> Option<usize> {
        self.ids.binary_search(&id).ok()
    }

    /// Adds nodes behind the others. Their parents and aims may be among them, which count on.
    ///
    /// # Errors
    /// What is wrong with one of them; nothing has changed then.
    pub fn add_all(&mut self, nodes: Vec<Node>) -> Result<()> {
        let count = self.nodes.len();
        let numbers = self.check_new(&nodes)?;
        let places = count..count + nodes.len();
        let mut all = SharedList::clone(&self.nodes);
        all.extend(nodes);
        self.order = hierarchy::order(&all).map_err(|(_, error)| error)?.into();
        *self.nodes = all;
        for number in places {
            let (Ok(place) | Err(place)) = self.place_of(&self.nodes[number].name);
            Arc::make_mut(&mut self.names).insert(place, number);
            Arc::make_mut(&mut self.ids).push(NodeId::fresh());
        }
        self.numbers = numbers;
        Ok(())
    }

    /// Checks nodes that come; gives the numbers that all keys have then.
    fn check_new(&self, nodes: &[Node]) -> Result<usize> {
        let count = self.nodes.len();
        let total = count + nodes.len();
        check_count(total)?;
        for (at, node) in nodes.iter().enumerate() {
            check_node(node, count + at)?;
            for (link, what) in [(node.parent, Place::Parent), (node.aim, Place::Aim)] {
                if let Some(node_there) = link.filter(|&link| link >= total) {
                    let error = Error::from(OutOfRange::NoNode {
                        node: node_there,
                        count: total,
                    });
                    return Err(error.at(what).at(Place::Node((&node.name).into())));
                }
            }
            if self.place_of(&node.name).is_ok() {
                return Err(taken(&node.name));
            }
        }
        let mut names = vec_with_room(nodes.len())?;
        names.extend(nodes.iter().map(|node| node.name.as_str()));
        names.sort_unstable();
        if let Some(twice) = names.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(taken(twice[0]));
        }
        let keys = nodes.iter().map(|node| node.keys.numbers());
        let numbers = self.numbers + keys.sum::<usize>();
        check_numbers(numbers)?;
        Ok(numbers)
    }

    /// For each node whether it is one of these or in one.
    ///
    /// # Errors
    /// [`Error::Range`] if there is no such node; [`Error::Memory`].
    pub fn with_all_in(&self, which: &[usize]) -> Result<Vec<bool>> {
        let mut within = vec_with_room(self.nodes.len())?;
        within.resize(self.nodes.len(), false);
        for &at in which {
            self.node(at)?;
            within[at] = true;
        }
        // Parents come before what is in them.
        for &at in self.order.iter() {
            within[at] |= self.nodes[at].parent.is_some_and(|parent| within[parent]);
        }
        Ok(within)
    }

    /// Takes nodes out, with all that is in them.
    pub(super) fn remove_nodes(&mut self, which: &[usize]) -> Result<()> {
        which
            .iter()
            .try_for_each(|&node| self.node(node).map(drop))?;
        let mut removal = Removal::new(self)?;
        for &node in which {
            removal.remove_place(node);
        }
        self.remove_all(removal);
        Ok(())
    }
}
