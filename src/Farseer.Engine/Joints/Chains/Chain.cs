using System.Runtime.InteropServices;

namespace Farseer.Engine.Joints.Chains;

/// <summary>A tree that is a chain of hinges, and where its numbers are.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal struct Chain
{
    public int Tree;
    public int Bodies;
    public int Joints;

    /// <summary>1 if it has an anchor at both ends: what cannot move before the first body is a body more.</summary>
    public int Front;

    /// <summary>Bodies on the first way down from the root, less one.</summary>
    public int Bend;

    /// <summary>Of its numbers, and of its places.</summary>
    public int First;
    public int PlaceFirst;

    /// <summary>It is solved here in the present passes; one that needs more is given back.</summary>
    public bool IsLive;

    /// <summary>The edition of the joints' settings that was looked at last, and what was found.</summary>
    public int Edition;
    public bool IsPlain;

    /// <summary>A joint can break by its force.</summary>
    public bool Breaks;

    /// <summary>The velocities in double are here, and not with the nodes.</summary>
    public bool HasVelocities;

    /// <summary>The arms of the rows are in the second of their two places.</summary>
    public bool Swapped;

    /// <summary>Contacts press on it, between two of its bodies, and it is solved here in the present passes.</summary>
    public bool IsPressed;
    public int Low;
    public int High;
    public int Middle;

    /// <summary>Of the bodies that contacts press on, the node nearest to the root.</summary>
    public int Top;

    /// <summary>What the present pass found before the contacts are swept.</summary>
    public ChainEnds Ends;

    /// <summary>Angle of what cannot move, of which sine and cosine are known.</summary>
    public double StillAngle;
    public double FrontAngle;

    public double Worst;
    public double Before;
    public bool Astray;

    /// <summary>The largest angle by which corrections turned a body.</summary>
    public double Bent;
}

/// <summary>A body of a chain, and the joint to the next.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal struct ChainPlace
{
    public int Node;
    public int Body;

    /// <summary>The active joint; -1: it is the last body, and nothing holds it.</summary>
    public int Active;

    /// <summary>The high body is body B of the joint.</summary>
    public bool IsHighB;
}
