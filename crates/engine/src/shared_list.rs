//! A list whose copies share its elements, so that a document and its history keep each but once.

use std::collections::HashSet;
use std::fmt;
use std::iter::Map;
use std::ops::{Deref, DerefMut, Index, IndexMut, Range, RangeBounds};
use std::slice::{self, SliceIndex};
use std::sync::Arc;

use crate::error::Result;
use crate::property::{SameBits, Stored};

/// So many elements are compared one by one.
const FEW: usize = 16;

/// A list whose copies share its elements: a copy costs a pointer for each element, and an element
/// is copied when it changes while another list has it, too.
#[derive(Clone)]
pub struct SharedList<T>(Vec<Arc<T>>);

impl<T> SharedList<T> {
    /// An empty list.
    #[must_use]
    pub const fn new() -> Self {
        Self(Vec::new())
    }

    /// Makes room for so many more elements.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn try_reserve(&mut self, more: usize) -> Result<()> {
        Ok(self.0.try_reserve(more)?)
    }

    /// A copy, for which there is memory.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn try_clone(&self) -> Result<Self> {
        let mut copy = crate::error::vec_with_room(self.len())?;
        copy.extend_from_slice(self);
        Ok(Self(copy))
    }

    /// The elements.
    pub fn iter(&self) -> Iter<'_, T> {
        self.0.iter().map(AsRef::as_ref)
    }

    /// The elements as they are shared.
    #[must_use]
    pub fn as_slice(&self) -> &[Arc<T>] {
        &self.0
    }

    /// Some of the elements.
    ///
    /// # Panics
    /// If there are none at some of these numbers.
    pub fn range(&self, which: impl SliceIndex<[Arc<T>], Output = [Arc<T>]>) -> Iter<'_, T> {
        self.0[which].iter().map(AsRef::as_ref)
    }

    /// An element, if there is one of this number.
    #[must_use]
    pub fn get(&self, at: usize) -> Option<&T> {
        self.0.get(at).map(AsRef::as_ref)
    }

    /// The first element.
    #[must_use]
    pub fn first(&self) -> Option<&T> {
        self.get(0)
    }

    /// The last element.
    #[must_use]
    pub fn last(&self) -> Option<&T> {
        self.0.last().map(AsRef::as_ref)
    }

    /// Puts another element in the place of one.
    ///
    /// # Panics
    /// If there is none of this number.
    pub fn set(&mut self, at: usize, element: impl Into<Arc<T>>) {
        self.0[at] = element.into();
    }

    /// Between which elements it differs from another list: before and behind both have the same
    /// ones. The first range is its own, the second that of the other list.
    #[must_use]
    pub fn difference(&self, other: &Self) -> [Range<usize>; 2] {
        let same = |(a, b): &(&Arc<T>, &Arc<T>)| Arc::ptr_eq(a, b);
        let begin = self.0.iter().zip(&other.0).take_while(same).count();
        let ends = self.0[begin..].iter().rev();
        let end = ends.zip(other.0[begin..].iter().rev());
        let end = end.take_while(same).count();
        [self, other].map(|list| begin..list.len() - end)
    }

    /// The elements that another list does not have.
    pub fn without<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = &'a T> {
        let [mine, theirs] = self.difference(other);
        let (mine, theirs) = (&self.0[mine], &other.0[theirs]);
        // A few are found without a table of them.
        let table = match theirs.len() {
            0..FEW => HashSet::new(),
            _ => theirs.iter().map(Arc::as_ptr).collect(),
        };
        mine.iter().map(AsRef::as_ref).filter(move |&element: &&T| {
            let is = |other: &Arc<T>| std::ptr::eq(Arc::as_ptr(other), element);
            match theirs.len() {
                0..FEW => !theirs.iter().any(is),
                _ => !table.contains(&std::ptr::from_ref(element)),
            }
        })
    }

    /// Appends an element.
    pub fn push(&mut self, element: impl Into<Arc<T>>) {
        self.0.push(element.into());
    }

    /// Inserts an element before the one at `at`.
    ///
    /// # Panics
    /// If `at` is beyond the end.
    pub fn insert(&mut self, at: usize, element: impl Into<Arc<T>>) {
        self.0.insert(at, element.into());
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
        self.0
            .splice(at..at, elements.into_iter().map(Into::into))
            .for_each(drop);
    }

    /// Removes an element.
    ///
    /// # Panics
    /// If there is none of this number.
    pub fn remove(&mut self, at: usize) -> Arc<T> {
        self.0.remove(at)
    }

    /// Removes the last element.
    pub fn pop(&mut self) -> Option<Arc<T>> {
        self.0.pop()
    }

    /// Keeps the first `count` elements.
    pub fn truncate(&mut self, count: usize) {
        self.0.truncate(count);
    }

    /// Removes all elements.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Keeps the elements for which `keep` is true.
    pub fn retain(&mut self, mut keep: impl FnMut(&T) -> bool) {
        self.0.retain(|element| keep(element));
    }

    /// Takes elements out.
    ///
    /// # Panics
    /// If there are none at some of these numbers.
    pub fn drain(&mut self, which: impl RangeBounds<usize>) -> impl Iterator<Item = Arc<T>> {
        self.0.drain(which)
    }
}

impl<T: Clone> SharedList<T> {
    /// The elements, to be changed: those that another list has, too, are copied.
    pub fn iter_mut(&mut self) -> IterMut<'_, T> {
        self.0.iter_mut().map(Arc::make_mut)
    }

    /// An element to be changed, if there is one of this number.
    pub fn get_mut(&mut self, at: usize) -> Option<&mut T> {
        self.0.get_mut(at).map(Arc::make_mut)
    }

    /// The last element, to be changed.
    pub fn last_mut(&mut self) -> Option<&mut T> {
        self.0.last_mut().map(Arc::make_mut)
    }
}

/// [`SharedList::iter`].
pub type Iter<'a, T> = Map<slice::Iter<'a, Arc<T>>, fn(&'a Arc<T>) -> &'a T>;
/// [`SharedList::iter_mut`].
pub type IterMut<'a, T> = Map<slice::IterMut<'a, Arc<T>>, fn(&'a mut Arc<T>) -> &'a mut T>;

impl<T> Default for SharedList<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: fmt::Debug> fmt::Debug for SharedList<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl<T: PartialEq> PartialEq for SharedList<T> {
    fn eq(&self, other: &Self) -> bool {
        let same = |(a, b): (&Arc<T>, &Arc<T>)| Arc::ptr_eq(a, b) || a == b;
        self.len() == other.len() && self.0.iter().zip(&other.0).all(same)
    }
}

impl<T: SameBits> SameBits for SharedList<T> {
    fn same_bits(&self, other: &Self) -> bool {
        let same = |(a, b): (&Arc<T>, &Arc<T>)| Arc::ptr_eq(a, b) || a.same_bits(b);
        self.len() == other.len() && self.0.iter().zip(&other.0).all(same)
    }
}

impl<T: SameBits + Clone> Stored for SharedList<T> {}

impl<T> Deref for SharedList<T> {
    type Target = [Arc<T>];

    fn deref(&self) -> &[Arc<T>] {
        &self.0
    }
}

impl<T> DerefMut for SharedList<T> {
    fn deref_mut(&mut self) -> &mut [Arc<T>] {
        &mut self.0
    }
}

impl<T> Index<usize> for SharedList<T> {
    type Output = T;

    fn index(&self, at: usize) -> &T {
        &self.0[at]
    }
}

impl<T: Clone> IndexMut<usize> for SharedList<T> {
    fn index_mut(&mut self, at: usize) -> &mut T {
        Arc::make_mut(&mut self.0[at])
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
        Self(elements.into_iter().map(Into::into).collect())
    }
}

impl<T, E: Into<Arc<T>>> Extend<E> for SharedList<T> {
    fn extend<I: IntoIterator<Item = E>>(&mut self, elements: I) {
        self.0.extend(elements.into_iter().map(Into::into));
    }
}

impl<T> IntoIterator for SharedList<T> {
    type Item = Arc<T>;
    type IntoIter = std::vec::IntoIter<Arc<T>>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
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
