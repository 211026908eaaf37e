//! A list whose copies share its elements, so that a document and its history keep each but once.

use std::cmp::Ordering;
use std::collections::HashSet;
use std::fmt;
use std::iter::{FlatMap, Map};
use std::ops::{Bound, Index, IndexMut, Range, RangeBounds};
use std::slice;
use std::sync::Arc;

use crate::error::Result;
use crate::property::{SameBits, Stored};

/// Below this length, elements are compared one by one, without a table.
const FEW: usize = 16;
/// Elements of a block. A copy and a change cost as much as there are blocks, and one block's
/// pointers: near the least of both sums at some thousand elements.
const BLOCK: usize = 64;

/// A list whose copies share its elements: a copy costs a pointer for every 64 elements, and
/// an element is copied when it changes while another list shares it.
#[derive(Clone)]
pub struct SharedList<T> {
    /// All but the last one are full.
    blocks: Vec<Arc<Block<T>>>,
    len: usize,
}

type Block<T> = Vec<Arc<T>>;

impl<T> SharedList<T> {
    /// An empty list.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            blocks: Vec::new(),
            len: 0,
        }
    }

    /// Reserves memory for `more` elements.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn try_reserve(&mut self, more: usize) -> Result<()> {
        Ok(self.blocks.try_reserve(more.div_ceil(BLOCK))?)
    }

    /// A copy, for which there is memory.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn try_clone(&self) -> Result<Self> {
        let mut blocks = crate::error::vec_with_room(self.blocks.len())?;
        blocks.extend_from_slice(&self.blocks);
        Ok(Self {
            blocks,
            len: self.len,
        })
    }

    /// The number of elements.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no elements.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The elements.
    pub fn iter(&self) -> Iter<'_, T> {
        self.range(..)
    }

    /// The elements as they are shared.
    pub fn shared(
        &self,
    ) -> impl DoubleEndedIterator<Item = &Arc<T>> + ExactSizeIterator + use<'_, T> {
        (0..self.len).map(|at| self.get_shared(at))
    }

    /// An element as it is shared.
    ///
    /// # Panics
    /// If `at` is out of bounds.
    #[must_use]
    pub fn get_shared(&self, at: usize) -> &Arc<T> {
        &self.blocks[at / BLOCK][at % BLOCK]
    }

    /// Some of the elements.
    ///
    /// # Panics
    /// If the range is out of bounds.
    pub fn range(&self, which: impl RangeBounds<usize>) -> Iter<'_, T> {
        Iter {
            list: self,
            rest: self.numbers(&which),
        }
    }

    /// The numbers that a range means.
    fn numbers(&self, which: &impl RangeBounds<usize>) -> Range<usize> {
        let first = match which.start_bound() {
            Bound::Included(&at) => at,
            Bound::Excluded(&at) => at + 1,
            Bound::Unbounded => 0,
        };
        let end = match which.end_bound() {
            Bound::Included(&at) => at + 1,
            Bound::Excluded(&at) => at,
            Bound::Unbounded => self.len,
        };
        assert!(first <= end && end <= self.len, "no such elements");
        first..end
    }

    /// An element, if there is one of this number.
    #[must_use]
    pub fn get(&self, at: usize) -> Option<&T> {
        (at < self.len).then(|| &self[at])
    }

    /// The first element.
    #[must_use]
    pub fn first(&self) -> Option<&T> {
        self.get(0)
    }

    /// The last element.
    #[must_use]
    pub fn last(&self) -> Option<&T> {
        self.blocks.last()?.last().map(AsRef::as_ref)
    }

    /// Puts another element in the place of one.
    ///
    /// # Panics
    /// If `at` is out of bounds.
    pub fn set(&mut self, at: usize, element: impl Into<Arc<T>>) {
        Arc::make_mut(&mut self.blocks[at / BLOCK])[at % BLOCK] = element.into();
    }

    /// The elements of whole blocks that both lists begin with.
    fn same_blocks(&self, other: &Self) -> usize {
        let blocks = self.blocks.iter().zip(&other.blocks);
        let same = blocks.take_while(|(a, b)| Arc::ptr_eq(a, b)).count();
        (same * BLOCK).min(self.len)
    }

    /// Between which elements it differs from another list: before and behind both have the same
    /// ones. The first range is its own, the second that of the other list.
    #[must_use]
    pub fn difference(&self, other: &Self) -> [Range<usize>; 2] {
        let same = |a: usize, b: usize| Arc::ptr_eq(self.get_shared(a), other.get_shared(b));
        let least = self.len.min(other.len);
        let mut begin = self.same_blocks(other);
        while begin < least && same(begin, begin) {
            begin += 1;
        }
        let mut end = 0;
        if self.len == other.len {
            // Blocks lie alike in both.
            let blocks = self.blocks.iter().zip(&other.blocks).rev();
            let blocks = blocks.take_while(|(a, b)| Arc::ptr_eq(a, b));
            end = blocks.map(|(block, _)| block.len()).sum::<usize>();
            end = end.min(least - begin);
        }
        while end < least - begin && same(self.len - 1 - end, other.len - 1 - end) {
            end += 1;
        }
        [self, other].map(|list| begin..list.len - end)
    }

    /// The elements that another list does not have.
    pub fn without<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = &'a T> {
        let [mine, theirs] = self.difference(other);
        let theirs = other.range(theirs);
        // A few are found without a table of them.
        let table = match theirs.len() {
            0..FEW => HashSet::new(),
            _ => theirs.clone().map(std::ptr::from_ref).collect(),
        };
        self.range(mine)
            .filter(move |&element: &&T| match theirs.len() {
                0..FEW => !theirs.clone().any(|other| std::ptr::eq(other, element)),
                _ => !table.contains(&std::ptr::from_ref(element)),
            })
    }

    /// Bytes of the list itself that another one does not share.
    #[must_use]
    pub fn heap_size_without(&self, other: &Self) -> usize {
        let pairs = self.blocks.iter().zip(&other.blocks);
        let same = pairs.filter(|(a, b)| Arc::ptr_eq(a, b)).count();
        size_of_val(&*self.blocks) + (self.blocks.len() - same) * BLOCK * size_of::<Arc<T>>()
    }

    /// Appends an element.
    pub fn push(&mut self, element: impl Into<Arc<T>>) {
        if self.len.is_multiple_of(BLOCK) {
            self.blocks.push(Arc::default());
        }
        if let Some(block) = self.blocks.last_mut() {
            Arc::make_mut(block).push(element.into());
            self.len += 1;
        }
    }

    /// Inserts an element before the one at `at`.
    ///
    /// # Panics
    /// If `at` is beyond the end.
    pub fn insert(&mut self, at: usize, element: impl Into<Arc<T>>) {
        self.insert_all(at, [element]);
    }

    /// Inserts elements before the one at `at`.
    ///
    /// # Panics
    /// If `at` is beyond the end.
    pub fn insert_all<E: Into<Arc<T>>>(
        &mut self,
        at: usize,
        elements: impl IntoIterator<Item = E>,
    ) {
        let behind = self.split_off(at);
        self.extend(elements);
        self.extend(behind);
    }

    /// Takes the elements from `at` on.
    fn split_off(&mut self, at: usize) -> Vec<Arc<T>> {
        let behind = self.numbers(&(at..));
        let behind = behind.map(|at| Arc::clone(self.get_shared(at))).collect();
        self.truncate(at);
        behind
    }

    /// Removes an element.
    ///
    /// # Panics
    /// If `at` is out of bounds.
    pub fn remove(&mut self, at: usize) -> Arc<T> {
        let element = Arc::clone(self.get_shared(at));
        let behind = self.split_off(at + 1);
        self.truncate(at);
        self.extend(behind);
        element
    }

    /// Removes the last element.
    pub fn pop(&mut self) -> Option<Arc<T>> {
        let last = self.len.checked_sub(1)?;
        Some(self.remove(last))
    }

    /// Keeps the first `count` elements.
    pub fn truncate(&mut self, count: usize) {
        if count < self.len {
            self.len = count;
            self.blocks.truncate(count.div_ceil(BLOCK));
            if let (Some(block), 1..) = (self.blocks.last_mut(), count % BLOCK) {
                Arc::make_mut(block).truncate(count % BLOCK);
            }
        }
    }

    /// Removes all elements.
    pub fn clear(&mut self) {
        *self = Self::new();
    }

    /// Keeps the elements for which `keep` is true.
    pub fn retain(&mut self, mut keep: impl FnMut(&T) -> bool) {
        *self = self
            .shared()
            .filter(|&element| keep(element))
            .map(Arc::clone)
            .collect();
    }

    /// Sorts the elements; equal ones keep their order.
    pub fn sort_by(&mut self, mut order: impl FnMut(&T, &T) -> Ordering) {
        let mut all: Vec<_> = self.drain(..).collect();
        all.sort_by(|a, b| order(a, b));
        self.extend(all);
    }

    /// Takes elements out.
    ///
    /// # Panics
    /// If the range is out of bounds.
    pub fn drain(&mut self, which: impl RangeBounds<usize>) -> std::vec::IntoIter<Arc<T>> {
        let which = self.numbers(&which);
        let behind = self.split_off(which.end);
        let out = self.split_off(which.start);
        self.extend(behind);
        out.into_iter()
    }
}

impl<T: 'static> SharedList<T> {
    /// An empty list, for where no list exists.
    pub const EMPTY: &'static Self = &Self::new();
}

impl<T: Clone> SharedList<T> {
    /// The elements, to be changed: those that another list has, too, are copied.
    pub fn iter_mut(&mut self) -> IterMut<'_, T> {
        self.blocks.iter_mut().flat_map(elements_mut)
    }

    /// An element to be changed, if there is one of this number.
    pub fn get_mut(&mut self, at: usize) -> Option<&mut T> {
        (at < self.len).then(|| &mut self[at])
    }

    /// The last element, to be changed.
    pub fn last_mut(&mut self) -> Option<&mut T> {
        self.get_mut(self.len.checked_sub(1)?)
    }
}

fn elements_mut<T: Clone>(block: &mut Arc<Block<T>>) -> ElementsMut<'_, T> {
    Arc::make_mut(block).iter_mut().map(Arc::make_mut)
}

/// [`SharedList::iter`].
pub struct Iter<'a, T> {
    list: &'a SharedList<T>,
    rest: Range<usize>,
}

impl<T> Clone for Iter<'_, T> {
    fn clone(&self) -> Self {
        let rest = self.rest.clone();
        Self { rest, ..*self }
    }
}

impl<'a, T> Iterator for Iter<'a, T> {
    type Item = &'a T;

    fn next(&mut self) -> Option<&'a T> {
        self.rest.next().map(|at| &self.list[at])
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.rest.size_hint()
    }

    fn nth(&mut self, n: usize) -> Option<&'a T> {
        self.rest.nth(n).map(|at| &self.list[at])
    }
}

impl<T> DoubleEndedIterator for Iter<'_, T> {
    fn next_back(&mut self) -> Option<Self::Item> {
        self.rest.next_back().map(|at| &self.list[at])
    }
}

impl<T> ExactSizeIterator for Iter<'_, T> {}

type ElementsMut<'a, T> = Map<slice::IterMut<'a, Arc<T>>, fn(&'a mut Arc<T>) -> &'a mut T>;
/// [`SharedList::iter_mut`].
pub type IterMut<'a, T> = FlatMap<
    slice::IterMut<'a, Arc<Block<T>>>,
    ElementsMut<'a, T>,
    fn(&'a mut Arc<Block<T>>) -> ElementsMut<'a, T>,
>;

impl<T> Default for SharedList<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: fmt::Debug> fmt::Debug for SharedList<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self).finish()
    }
}

impl<T> SharedList<T> {
    /// Whether all elements are equal; those that both lists share are not compared.
    fn equal(&self, other: &Self, equal: impl Fn(&T, &T) -> bool) -> bool {
        let from = self.same_blocks(other).min(other.len);
        let same = |(a, b): (&T, &T)| std::ptr::eq(a, b) || equal(a, b);
        self.len == other.len && self.range(from..).zip(other.range(from..)).all(same)
    }
}

impl<T: PartialEq> PartialEq for SharedList<T> {
    fn eq(&self, other: &Self) -> bool {
        self.equal(other, T::eq)
    }
}

impl<T: SameBits> SameBits for SharedList<T> {
    fn same_bits(&self, other: &Self) -> bool {
        self.equal(other, T::same_bits)
    }
}

impl<T: SameBits + Clone> Stored for SharedList<T> {}

impl<T> Index<usize> for SharedList<T> {
    type Output = T;

    fn index(&self, at: usize) -> &T {
        self.get_shared(at)
    }
}

impl<T: Clone> IndexMut<usize> for SharedList<T> {
    fn index_mut(&mut self, at: usize) -> &mut T {
        Arc::make_mut(&mut Arc::make_mut(&mut self.blocks[at / BLOCK])[at % BLOCK])
    }
}

impl<T> From<Vec<T>> for SharedList<T> {
    fn from(elements: Vec<T>) -> Self {
        elements.into_iter().collect()
    }
}

impl<T, const N: usize> From<[T; N]> for SharedList<T> {
    fn from(elements: [T; N]) -> Self {
        elements.into_iter().collect()
    }
}

impl<T, E: Into<Arc<T>>> FromIterator<E> for SharedList<T> {
    fn from_iter<I: IntoIterator<Item = E>>(elements: I) -> Self {
        let mut list = Self::new();
        list.extend(elements);
        list
    }
}

impl<T, E: Into<Arc<T>>> Extend<E> for SharedList<T> {
    fn extend<I: IntoIterator<Item = E>>(&mut self, elements: I) {
        elements.into_iter().for_each(|element| self.push(element));
    }
}

impl<T> IntoIterator for SharedList<T> {
    type Item = Arc<T>;
    type IntoIter = std::vec::IntoIter<Arc<T>>;

    fn into_iter(mut self) -> Self::IntoIter {
        self.drain(..)
    }
}

impl<'a, T> IntoIterator for &'a SharedList<T> {
    type Item = &'a T;
    type IntoIter = Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<'a, T: Clone> IntoIterator for &'a mut SharedList<T> {
    type Item = &'a mut T;
    type IntoIter = IterMut<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter_mut()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_copy_shares_all_but_what_has_changed() {
        let mut list: SharedList<String> = ["a", "b", "c", "d"].map(str::to_owned).into();
        let copy = list.clone();
        assert_eq!(list.difference(&copy), [4..4, 4..4]);
        list[1].push('x');
        assert_eq!((&*copy[1], &*list[1]), ("b", "bx"));
        assert_eq!(list.difference(&copy), [1..2, 1..2]);
        assert!(list.without(&copy).eq(["bx"]) && copy.without(&list).eq(["b"]));
        list.insert(3, "new".to_owned());
        list.remove(0);
        assert_eq!(list.difference(&copy), [0..3, 0..3]);
        assert!(list.without(&copy).eq(["bx", "new"]) && copy.without(&list).eq(["a", "b"]));
        // Nothing is copied that only one list has.
        let address = std::ptr::from_ref(&list[0]);
        list[0].push('y');
        assert!(std::ptr::eq(address, &list[0]));
    }

    /// Random changes of a list and of a plain one, and differences of copies.
    #[test]
    fn it_is_what_a_plain_list_is() {
        let mut seed = 1_u64;
        let mut random = |below: usize| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 33) as usize % below.max(1)
        };
        let (mut list, mut plain) = (SharedList::<usize>::new(), Vec::new());
        let mut before = list.clone();
        for number in 0..4000 {
            let (at, count) = (random(plain.len() + 1), plain.len());
            let to = at + random(count - at + 1);
            match random(10) {
                0..3 => (list.push(number), plain.push(number)),
                3 => (list.insert(at, number), plain.insert(at, number)),
                4 => {
                    let more = number..number + random(150);
                    list.insert_all(at, more.clone());
                    ((), drop(plain.splice(at..at, more)))
                }
                5 if at < count => (drop(list.remove(at)), _ = plain.remove(at)),
                6 if at < count => (list.set(at, number), plain[at] = number),
                7 if at < count => (list[at] += 1, plain[at] += 1),
                8 if count > 600 => (drop(list.drain(at..to)), drop(plain.drain(at..to))),
                9 if count > 900 => (list.truncate(at), plain.truncate(at)),
                _ => (drop(list.pop()), _ = plain.pop()),
            };
            assert!(list.iter().eq(&plain) && list.len() == plain.len());
            assert!(list.iter().rev().eq(plain.iter().rev()) && list.last() == plain.last());
            let [new, old] = list.difference(&before);
            let same = |(a, b): (&usize, &usize)| std::ptr::eq(a, b);
            assert!(
                list.range(..new.start)
                    .zip(before.range(..old.start))
                    .all(same)
            );
            let behind = list.range(new.end..).zip(before.range(old.end..));
            assert!(behind.len() == before.len() - old.end && { behind }.all(same));
            if random(5) == 0 {
                before = list.clone();
            }
        }
    }

    #[test]
    fn moved_elements_of_long_lists_are_known() {
        let long: SharedList<usize> = (0..1000).collect();
        let mut moved = long.clone();
        let element = moved.remove(900);
        moved.insert(10, element);
        moved.set(500, 7_usize);
        assert_eq!(moved.difference(&long), [10..901, 10..901]);
        assert!(moved.without(&long).eq(&[7]) && long.without(&moved).eq(&[499]));
        assert_ne!(moved, long);
    }
}
