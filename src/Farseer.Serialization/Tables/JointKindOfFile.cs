using System;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Serialization.Tables;

/// <summary>A kind of joint: its name in files, its members, and how one is made, of two bodies or of one.</summary>
internal sealed class JointKindOfFile
{
    public JointKindOfFile(string name, Type type, Table table, Func<Body, Body, Joint>? ofPair, Func<Body, Joint>? ofOne)
    {
        Name = name;
        Type = type;
        Table = table;
        OfPair = ofPair;
        OfOne = ofOne;
    }

    public string Name { get; }

    public Type Type { get; }

    public Table Table { get; }

    public Func<Body, Body, Joint>? OfPair { get; }

    public Func<Body, Joint>? OfOne { get; }
}
