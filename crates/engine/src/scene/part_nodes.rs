//! Nodes that come into a scene and go out of it, with what leads to them ([`super::part`]).

use super::hierarchy;
use super::node::Node;
use super::node_list::NodeList;
use super::scene::{Scene, check_count, check_node, check_numbers, taken};
use crate::error::{Error, OutOfRange, Place, Result, vec_with_room};

impl NodeList {
    /// Nodes that come behind the others of a scene; their parents and aims are numbers in it, the
    /// first of them has the number [`Scene::nodes`] are.
    ///
    /// # Errors
    /// [`Error::Memory`].
    pub fn behind(scene: &Scene, nodes: Vec<Node>) -> Result<Self> {
        let count = scene.nodes().len();
        let mut places = vec_with_room(nodes.len())?;
        places.extend(count..count + nodes.len());
        Ok(Self {
            places,
            nodes,
            ..Self::default()
        })
    }
}

const GONE: usize = usize::MAX;

impl Scene {
    /// Puts nodes in and gives their numbers.
    pub(super) fn insert_nodes(&mut self, list: &mut NodeList) -> Result<Vec<usize>> {
        let numbers = self.check_new(list)?;
        let total = self.nodes.len() + list.nodes.len();
        let mut places = vec_with_room(list.places.len())?;
        places.extend_from_slice(&list.places);
        let mut new = vec_with_room(self.nodes.len())?;
        let mut coming = list.places.iter().copied().peekable();
        new.extend((0..total).filter(|number| coming.next_if_eq(number).is_none()));
        let mut all: Vec<Node> = vec_with_room(total)?;
        self.names.try_reserve(places.len())?;
        self.order.try_reserve(places.len())?;
        self.pins.try_reserve(list.pins.len())?;
        self.renumber(&new);
        let mut old = std::mem::take(&mut *self.nodes).into_iter();
        let mut coming = places.iter().peekable();
        let mut nodes = list.nodes.drain(..);
        for number in 0..total {
            let node = match coming.next_if_eq(&&number) {
                Some(_) => nodes.next(),
                None => old.next(),
            };
            all.extend(node);
        }
        drop(nodes);
        *self.nodes = all;
        for &(node, aim) in &list.aims {
            self.nodes[node].aim = Some(aim);
        }
        self.pins.append(&mut list.pins);
        self.pins.sort_by_key(|pin| (pin.node, pin.point));
        self.camera = self.camera.or(list.camera);
        self.numbers = numbers;
        for &number in &places {
            let (Ok(place) | Err(place)) = self.place_of(&self.nodes[number].name);
            self.names.insert(place, number);
        }
        match hierarchy::order(&self.nodes) {
            Ok(order) => {
                self.order = order;
                Ok(places)
            }
            Err((_, error)) => {
                self.order.extend_from_slice(&places);
                *list = self.take_out(&places)?;
                Err(error)
            }
        }
    }

    /// Checks nodes that come; gives the numbers that all keys have then.
    fn check_new(&self, list: &NodeList) -> Result<usize> {
        let total = self.nodes.len() + list.nodes.len();
        check_count(total)?;
        let fits = list.places.len() == list.nodes.len()
            && list.places.is_sorted_by(|a, b| a < b)
            && list.places.iter().all(|&place| place < total);
        if !fits {
            let node = list.places.last().copied().unwrap_or(0);
            return Err(OutOfRange::NoNode { node, count: total }.into());
        }
        for (&place, node) in list.places.iter().zip(&list.nodes) {
            check_node(node, place)?;
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
        let mut names = vec_with_room(list.nodes.len())?;
        names.extend(list.nodes.iter().map(|node| node.name.as_str()));
        names.sort_unstable();
        if let Some(twice) = names.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(taken(twice[0]));
        }
        let keys = list.nodes.iter().map(|node| node.keys.numbers());
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
        for &at in &self.order {
            within[at] |= self.nodes[at].parent.is_some_and(|parent| within[parent]);
        }
        Ok(within)
    }

    /// Takes nodes out, with all that is in them.
    pub(super) fn remove_nodes(&mut self, which: &[usize]) -> Result<NodeList> {
        let gone = self.with_all_in(which)?;
        let mut places = vec_with_room(gone.iter().filter(|&&gone| gone).count())?;
        places.extend((0..gone.len()).filter(|&at| gone[at]));
        self.take_out(&places)
    }

    /// Takes out nodes, in rising order, in which there are no others.
    fn take_out(&mut self, places: &[usize]) -> Result<NodeList> {
        let gone = |at: usize| places.binary_search(&at).is_ok();
        let aimed = |node: &Node| node.aim.filter(|&aim| gone(aim));
        let staying = || {
            let all = self.nodes.iter().enumerate();
            all.filter_map(|(at, node)| Some((at, aimed(node)?)))
                .filter(|&(at, _)| !gone(at))
        };
        let mut list = NodeList {
            places: vec_with_room(places.len())?,
            nodes: vec_with_room(places.len())?,
            aims: vec_with_room(staying().count())?,
            pins: vec_with_room(self.pins.iter().filter(|pin| gone(pin.node)).count())?,
            camera: self.camera.filter(|&camera| gone(camera)),
        };
        list.places.extend_from_slice(places);
        list.aims.extend(staying());
        let mut new = vec_with_room(self.nodes.len())?;
        let mut next = 0;
        for at in 0..self.nodes.len() {
            new.push(if gone(at) { GONE } else { next });
            next += usize::from(!gone(at));
        }
        for &(node, _) in &list.aims {
            self.nodes[node].aim = None;
        }
        list.pins
            .extend(self.pins.extract_if(.., |pin| gone(pin.node)));
        for names in [&mut self.names, &mut self.order] {
            names.retain(|&node| new[node] != GONE);
        }
        self.camera = self.camera.filter(|&camera| !gone(camera));
        let mut at = 0;
        list.nodes.extend(self.nodes.extract_if(.., |_| {
            at += 1;
            new[at - 1] == GONE
        }));
        self.renumber(&new);
        let keys = list.nodes.iter().map(|node| node.keys.numbers());
        self.numbers -= keys.sum::<usize>();
        Ok(list)
    }

    /// Gives every node that is there the number that stands at its old one.
    fn renumber(&mut self, new: &[usize]) {
        let number = |old: &mut usize| *old = new[*old];
        for node in self.nodes.iter_mut() {
            node.parent.iter_mut().for_each(number);
            node.aim.iter_mut().for_each(number);
        }
        self.names.iter_mut().for_each(number);
        self.order.iter_mut().for_each(number);
        self.pins
            .iter_mut()
            .map(|pin| &mut pin.node)
            .for_each(number);
        self.camera.iter_mut().for_each(number);
    }
}
