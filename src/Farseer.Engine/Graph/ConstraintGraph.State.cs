using System;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <content>Saving and restoring.</content>
internal sealed unsafe partial class ConstraintGraph
{
    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        RowCount = s.Value(RowCount);
        NewRows = s.Value(NewRows);
        Changed = s.Value(Changed);
        ChangeCount = s.Value(ChangeCount);
        s.Value(ref _isSmall);
        s.Value(ref _sharedRows);
        s.Column(_changes, Math.Min(ChangeCount, MostChanges));
        s.Column(_degree);
        _bodies.Visit(s);
        Groups.Visit(s);
        _arena.Visit(s);
        int groups = s.Value(HeldGroups());

        // A row may come to a group of which none is held at present.
        NeedGroups(Groups.InUse > 1 ? Math.Max(groups, Groups.InUse) : groups);

        for (int i = 0; i < _colors.Count; i++)
        {
            for (int color = 0; color <= ColorCount; color++)
            {
                if (i < groups && s.Value(_colors[i][color].HoldsAny))
                {
                    _colors[i][color].Visit(s.Of("Color", color));
                }
                else
                {
                    _colors[i][color].ForgetAll();
                }
            }
        }

        _usedChanged |= s.IsReading;
    }

    /// <summary>Groups up to the last that has rows, or room for some: how many were made is no state.</summary>
    private int HeldGroups()
    {
        for (int groups = _colors.Count; groups > 0; groups--)
        {
            foreach (GraphColor color in _colors[groups - 1])
            {
                if (color.HoldsAny)
                {
                    return groups;
                }
            }
        }

        return 0;
    }
}
