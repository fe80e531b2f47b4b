using System;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// What hangs on, rests on or carries a part of a tree: the heaviest body and whether something immovable holds it, each by
/// contacts and by joints apart.
/// </summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal struct TreeLoad
{
    public double ContactMass;
    public double JointMass;
    public bool ContactHeld;
    public bool JointHeld;

    public void Add(in TreeLoad other)
    {
        ContactMass = Math.Max(ContactMass, other.ContactMass);
        JointMass = Math.Max(JointMass, other.JointMass);
        ContactHeld |= other.ContactHeld;
        JointHeld |= other.JointHeld;
    }

    /// <summary>
    /// The greatest mass that a body between the two parts passes on, where a contact has a share in it: what joints alone pass on is
    /// solved exactly.
    /// </summary>
    public static double Between(in TreeLoad a, in TreeLoad b)
    {
        double heavy = Math.Min(a.ContactMass, b.Whole);
        heavy = Math.Max(heavy, Math.Min(b.ContactMass, a.Whole));
        heavy = Math.Max(heavy, a.ContactHeld ? b.JointMass : 0);
        return Math.Max(heavy, b.ContactHeld ? a.JointMass : 0);
    }

    private readonly double Whole => ContactHeld || JointHeld ? double.PositiveInfinity : Math.Max(ContactMass, JointMass);
}
