using System.Runtime.InteropServices;
using System;
using Farseer.Engine.Joints.Solving;

namespace Farseer.Engine.Joints.Trees;

/// <summary>One tree: a range of nodes in pre-order, its anchors, and what holds for all of it.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal struct JointTree
{
    public int First;

    /// <summary>One past the last node.</summary>
    public int End;
    public int AnchorFirst;
    public int AnchorEnd;

    /// <summary>The joints that close loops in it; their rows, and where the inverse of these rows' responses stands.</summary>
    public int LoopFirst;
    public int LoopEnd;
    public int LoopRow;
    public int LoopRows;

    /// <summary>How many of these rows always hold: limits follow them.</summary>
    public int LoopHard;
    public int LoopSquare;

    /// <summary>The first of the rows of limits, and one past the last row.</summary>
    public readonly int FirstLoopLimit => LoopRow + LoopHard;
    public readonly int LoopRowEnd => LoopRow + LoopRows;

    /// <summary>A body without joints that touches a tree: it takes part so that rows between the two have one form.</summary>
    public bool Guest;

    /// <summary>
    /// Eliminated joints hold its bodies, so a body's own mass says little about how it gives way: contacts must see that of the
    /// tree. Single bodies without anchors are left to the coloured contacts.
    /// </summary>
    public bool Eliminates;

    /// <summary>Its only body can do nothing but turn about its centre.</summary>
    public bool Wheel;

    /// <summary>Limits belong to its blocks.</summary>
    public bool HasLimits;

    /// <summary>It has edges that nothing but limits makes.</summary>
    public bool LimitEdges;

    /// <summary>It is a chain of hinges, anchored at its ends or not at all; and which of the chains.</summary>
    public bool IsChain;
    public int Chain;

    /// <summary>A chain that is solved as such in this step although contacts press on it; and one that may be.</summary>
    public bool OnChain;
    public bool MayPress;

    /// <summary>A chain that is solved as such in this step: it is in none of the lists of the general passes.</summary>
    public bool IsQuiet;

    /// <summary>Rows are iterated against its inverse mass: its bodies' full masses are needed.</summary>
    public bool HasRows;

    /// <summary>Joints that are no part of it push at it.</summary>
    public bool Joined;

    /// <summary>Contacts, or joints that are no part of it, push at it.</summary>
    public bool Tied;

    /// <summary>Contacts push at it, and all of them with something that cannot move or among its own bodies.</summary>
    public bool Touched;

    /// <summary>Contacts are solved against it.</summary>
    public bool Pressed;

    /// <summary>
    /// Nothing touches it and nothing springy pulls at it, nor at any tree that rows tie to it: it takes half of all forces before it moves
    /// and half after.
    /// </summary>
    public bool Free;

    /// <summary>A single body, in a group of such, that nothing but joints without hard rows has rows at.</summary>
    public bool Wishes;

    /// <summary>A joint that is not of limits alone has rows at it.</summary>
    public bool Wished;

    /// <summary>Springs pull at it in this step.</summary>
    public bool Pulled;

    /// <summary>The same, and if it is a single body too.</summary>
    public bool Strung;

    /// <summary>Rows of springs that joints have at its bodies.</summary>
    public int SpringRows;

    /// <summary>It was disturbed in the substep before: until nothing is left of its errors they count as put there from outside.</summary>
    public bool Unsettled;

    /// <summary>A limit at it stands aside, and is pulled to its place.</summary>
    public bool Overrun;

    /// <summary>An error that was put there from outside waits to be taken out; the correction went astray; its limits changed.</summary>
    public bool Disturbed;
    public bool Astray;
    public bool Refactored;

    /// <summary>Its displacements are kept in double: only the joints' passes move its bodies.</summary>
    public bool Exact;

    /// <summary>Its correction is taken back, since a tree that it touches went astray.</summary>
    public bool Undone;

    /// <summary>It was projected as if its bodies were equally heavy.</summary>
    public bool Levelled;

    /// <summary>The share of its projection that acts on speeds.</summary>
    public double Impelled;

    /// <summary>Takes part in the present round of the position correction.</summary>
    public bool Corrects;

    /// <summary>The first of the trees that iterated rows tie to this one, itself among them.</summary>
    public int Group;

    /// <summary>Of the first tree of a group: the group takes part in the sweep that is made for some only.</summary>
    public bool GroupActs;

    /// <summary>
    /// Of the first tree of a group: the largest change of a speed that its contacts made in a sweep, the largest in any sweep of the pass
    /// so far, and whether it is swept over again.
    /// </summary>
    public double Change;
    public double LargestChange;
    public bool Goes;

    /// <summary>Of the first tree of a group: the squares of what its contacts changed in the last sweep and in the one before.</summary>
    public double Residual;
    public double ResidualBefore;

    /// <summary>
    /// Of the first tree of a group: the largest turn in a displacement, and whether limits are pulled there, or overlaps pushed apart.
    /// </summary>
    public double Turned;
    public bool GroupPulls;

    /// <summary>It is solved on lanes in this step, and in no list of the other passes.</summary>
    public bool OnLanes;

    /// <summary>It is one body, and goes side by side with others that only joints without hard rows hold.</summary>
    public bool Loose;

    /// <summary>A walk brought an impulse.</summary>
    public bool Carries;

    /// <summary>The node at which the lazy walk stands, one of the tree at any time.</summary>
    public int Current;

    /// <summary>Substeps are counted by class: a tree takes part in the passes of its class only.</summary>
    public int Class;

    /// <summary>How long before the end of the substep its impact was.</summary>
    public double Since;

    /// <summary>Whether an error, in terms of its joint's size, is one from outside.</summary>
    public readonly bool IsOutside(double error) => error > (Disturbed || Unsettled ? Math.Min(TreePositions.Loose, Outside) : Outside);

    /// <summary>The error, in terms of its joint's size, above which one is from outside.</summary>
    public double Outside;

    /// <summary>Errors may be from outside that elsewhere would be motion: it is for the general passes.</summary>
    public readonly bool IsSuspect => Disturbed || Outside < TreeRows.Small;

    /// <summary>Largest error of the tree now and a round ago, in terms of its joints' sizes.</summary>
    public double Worst;
    public double Before;

    /// <summary>Of the first tree of a group: impulses of one of its trees on itself are tempered.</summary>
    public bool GroupTempers;

    /// <summary>
    /// Surfaces within the tree press on each other; what the impulses that they start from do against the speeds that are there without
    /// them, and against those that they make themselves.
    /// </summary>
    public bool Tempers;
    public double Opposed;
    public double Answered;

    /// <summary>
    /// Of the first tree of a group: velocities and impulses from before joints pushed at limits that hold are kept; and twice the energy
    /// gained since.
    /// </summary>
    public bool Kept;
    public double Gained;
}
